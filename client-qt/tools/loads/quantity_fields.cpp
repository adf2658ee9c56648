// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/quantity_fields.hpp"

#include <QHBoxLayout>
#include <QLabel>

#include <cmath>

#include "client-qt/model/quantities.hpp"
#include "client-qt/model/typed_quantity.hpp"

namespace tedit::desktop {

static const QString widest_unit = QString::fromUtf8("kg/m³");  ///< Fields end below each other.

quantity_field::quantity_field(const QString& name, const QString& accessible,
                               const QString& si_unit)
    : what_(accessible) {
  setObjectName(name);
  setMinimumSize(44, sizeHint().height());  // The form is cut off before they are.
  set_unit(si_unit);
}

void quantity_field::set_unit(const QString& si_unit) {
  si_unit_ = si_unit;
  const auto unit = unit_name();
  setAccessibleName(unit.isEmpty() ? what_ : tr("%1 in %2").arg(what_, unit));
  const auto others = other_units(si_unit);
  setToolTip(others.isEmpty() ? QString() : tr("In %1, or typed with %2").arg(unit, others));
}

QString quantity_field::unit_name() const {
  return shown_as(si_unit_).name;
}

double quantity_field::value() const {
  return read_quantity(text(), si_unit_).value_or(NAN);
}

void quantity_field::set_value(double in_si) {
  setText(exact(in_si * shown_as(si_unit_).scale));
}

QWidget* with_unit(quantity_field* field) {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(field, 1);
  auto* unit = new QLabel(field->unit_name());
  unit->setMinimumWidth(QLabel(widest_unit).sizeHint().width());
  row->addWidget(unit);
  return box;
}

vector_field::vector_field(const QString& name, const QString& accessible, const QString& si_unit)
    : unit_(new QLabel) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    parts_[i] = new quantity_field(name + "_" + axes[i], accessible.arg(axes[i]), si_unit);
    connect(parts_[i], &QLineEdit::textChanged, this, &vector_field::changed);
    connect(parts_[i], &QLineEdit::returnPressed, this, &vector_field::accepted);
    row->addWidget(new QLabel(axes[i]));
    row->addWidget(parts_[i], 1);
  }
  row->addWidget(unit_);
  set_unit(si_unit);
}

void vector_field::set_unit(const QString& si_unit) {
  for (auto* part : parts_)
    part->set_unit(si_unit);
  unit_->setText(parts_.front()->unit_name());
}

vec3 vector_field::value() const {
  return {parts_[0]->value(), parts_[1]->value(), parts_[2]->value()};
}

void vector_field::set_value(const vec3& in_si) {
  parts_[0]->set_value(in_si.x);
  parts_[1]->set_value(in_si.y);
  parts_[2]->set_value(in_si.z);
}

QString vector_field::size_in_words() const {
  const double size = norm(value());
  if (!std::isfinite(size) || size == 0)
    return {};
  const auto shown = shown_as(parts_[0]->si_unit());
  return tr("%1 %2 in all").arg(number(size * shown.scale), shown.name);
}

}  // namespace tedit::desktop
