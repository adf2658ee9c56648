// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/field_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDoubleValidator>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <utility>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

field_panel::field_panel(document& part, QWidget* parent) : QWidget(parent), part_(part) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(12, 10, 12, 10);
  field_ = new QComboBox;
  field_->setObjectName("field");
  for (const auto one :
       {shown_field::von_mises, shown_field::displacement, shown_field::displacement_x,
        shown_field::displacement_y, shown_field::displacement_z, shown_field::safety_factor,
        shown_field::surfaces, shown_field::none})
    field_->addItem(field_title(one), static_cast<int>(one));
  case_ = new QComboBox;
  case_->setObjectName("load_case");
  map_ = new QComboBox;
  map_->addItems({tr("Viridis"), tr("Cividis"), tr("Grey"), tr("Cool to warm")});
  mode_ = new QComboBox;
  mode_->setObjectName("range_mode");
  mode_->addItems({tr("Automatic"), tr("As typed"), tr("Locked across versions")});
  low_ = new QLineEdit;
  high_ = new QLineEdit;
  for (auto* edit : {low_, high_}) {
    edit->setValidator(new QDoubleValidator(edit));
    edit->setMinimumWidth(60);
  }
  low_->setAccessibleName(tr("Lowest value"));
  high_->setAccessibleName(tr("Highest value"));
  log_ = new QCheckBox(tr("Logarithmic"));
  deform_ = new QDoubleSpinBox;
  deform_->setObjectName("deform");
  deform_->setRange(0, 1e6);
  deform_->setDecimals(0);
  deform_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  deform_->setPrefix(QString::fromUtf8("\u00d7 "));
  deform_->setSpecialValueText(tr("not deformed"));
  auto* range = new QWidget;
  auto* row = new QHBoxLayout(range);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(low_);
  row->addWidget(high_);
  form->addRow(tr("Field"), field_);
  form->addRow(tr("Load case"), case_);
  form->addRow(tr("Range"), mode_);
  form->addRow(QString(), range);
  form->addRow(QString(), log_);
  form->addRow(tr("Colours"), map_);
  form->addRow(tr("Deformation"), deform_);
  for (auto* box : {field_, case_, map_, mode_})
    connect(box, &QComboBox::currentIndexChanged, this, &field_panel::read_form);
  for (auto* edit : {low_, high_})
    connect(edit, &QLineEdit::editingFinished, this, &field_panel::read_form);
  connect(log_, &QCheckBox::toggled, this, &field_panel::read_form);
  connect(deform_, &QDoubleSpinBox::valueChanged, this, &field_panel::read_form);
  connect(&part_, &document::field_changed, this, &field_panel::list_cases);
  connect(&part_, &document::head_changed, this, &field_panel::list_cases);
  connect(&part_, &document::opened, this, [this] {
    to_lock_ = locks_;
    if (locks_)
      mode_->setCurrentIndex(static_cast<int>(range_mode::automatic));
  });
  read_form();
}

/// One entry for each load case and one for the envelope; the choice stays where it was.
void field_panel::list_cases() {
  const auto* head = part_.head();
  const QString before = case_->currentText();
  {
    const QSignalBlocker quiet(case_);
    case_->clear();
    if (head)
      for (const auto& field : head->fields)
        case_->addItem(field->envelope ? tr("Envelope of all")
                                       : QString::fromStdString(field->report.load_case));
    const int same = case_->findText(before);
    case_->setCurrentIndex(same >= 0 ? same : case_->count() - 1);
    case_->setEnabled(case_->count() > 1);
  }
  emit changed();
}

shared_field field_panel::field() const {
  const auto* head = part_.head();
  const auto at = case_->currentIndex();
  if (!head || at < 0 || at >= static_cast<int>(head->fields.size()))
    return nullptr;
  return head->fields[static_cast<std::size_t>(at)];
}

double field_panel::deform() const {
  return deform_->value();
}

void field_panel::set_field(shown_field field) {
  field_->setCurrentIndex(field_->findData(static_cast<int>(field)));
}

void field_panel::set_deform(double factor) {
  deform_->setValue(factor);
}

void field_panel::set_look(colour_map map, bool locked, bool logarithmic) {
  map_->setCurrentIndex(static_cast<int>(map));
  log_->setChecked(logarithmic);
  if (std::exchange(locks_, locked) != locked)
    mode_->setCurrentIndex(static_cast<int>(range_mode::automatic));
  to_lock_ = locked && legend_.mode == range_mode::automatic;
}

void field_panel::read_form() {
  const auto before = legend_.field;
  legend_.field = static_cast<shown_field>(field_->currentData().toInt());
  legend_.map = static_cast<colour_map>(map_->currentIndex());
  legend_.mode = static_cast<range_mode>(mode_->currentIndex());
  legend_.logarithmic = log_->isChecked();
  const bool typed = legend_.mode == range_mode::manual;
  low_->setEnabled(typed);
  high_->setEnabled(typed);
  if (legend_.field != before && legend_.mode != range_mode::automatic) {
    mode_->setCurrentIndex(0);  // Another quantity: the old range means nothing. Comes back here.
    return;
  }
  if (typed) {
    const double scale = shown_as(field_unit(legend_.field)).scale;
    const double low = low_->text().toDouble() / scale;
    const double high = high_->text().toDouble() / scale;
    if (high > low) {
      legend_.low = low;
      legend_.high = high;
    }
  }
  emit changed();
}

void field_panel::take_range(const legend& shown) {
  if (legend_.mode != range_mode::automatic)
    return;
  legend_.low = shown.low;
  legend_.high = shown.high;
  const double scale = shown_as(field_unit(shown.field)).scale;
  low_->setText(number(shown.low * scale));
  high_->setText(number(shown.high * scale));
  const auto now = field();
  if (to_lock_ && now && !now->interim()) {
    to_lock_ = false;  // Later: the view is in the middle of painting.
    QMetaObject::invokeMethod(
      this, [this] { mode_->setCurrentIndex(static_cast<int>(range_mode::locked)); },
      Qt::QueuedConnection);
  }
}

}  // namespace tedit::desktop
