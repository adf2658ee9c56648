// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/load_form.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <cmath>

#include "client-qt/tools/loads/quantity_fields.hpp"

namespace tedit::desktop {

namespace {

/// The place of each kind in the variant.
enum load_index : std::size_t {
  force,
  traction,
  pressure,
  gravity,
  normal_force,
  moment,
  remote_force,
  pin
};

/// A kind as people choose it.
struct kind_row {
  load_index index;
  const char* title;
  const char* hint;
  const char* unit;  ///< Of its components, or of its size along the normal.
};

/// In the order of the choice: the frequent ones first.
constexpr kind_row kinds[] = {
  {force, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Force, spread over the surfaces"), "",
   "N"},
  {normal_force, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Force along the normal"),
   QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Positive pushes on the part, negative pulls"),
   "N"},
  {pressure, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Pressure, along the normal"),
   QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Positive pushes on the part, negative pulls"),
   "Pa"},
  {pin, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Bearing: a pin presses on its bore"),
   QT_TRANSLATE_NOOP("tedit::desktop::load_form",
                     "The force of the pin, across the bore; only the half that it faces carries"),
   "N"},
  {moment, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Moment"),
   QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Turns about this direction, right-handed"),
   "N m"},
  {remote_force, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Remote force, at a place apart"),
   QT_TRANSLATE_NOOP("tedit::desktop::load_form",
                     "As if a rigid lever led from the place to the surfaces"),
   "N"},
  {traction, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Traction, per area"), "", "Pa"},
  {gravity, QT_TRANSLATE_NOOP("tedit::desktop::load_form", "Gravity, on all mass"), "", "m/s2"},
};
static_assert(std::size(kinds) == std::variant_size_v<decltype(fem::load::kind)>);

const kind_row& row_of(std::size_t index) {
  return *std::ranges::find(kinds, static_cast<load_index>(index), &kind_row::index);
}

bool along_normal(std::size_t index) {
  return index == pressure || index == normal_force;
}

void show_row(QWidget* field, bool shown) {
  auto* form = static_cast<QFormLayout*>(field->parentWidget()->layout());
  form->setRowVisible(field, shown);
}

}  // namespace

load_form::load_form() : kind_(new QComboBox), hint_(new QLabel), size_(new QLabel) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  kind_->setObjectName("load_kind");
  for (const auto& row : kinds)
    kind_->addItem(tr(row.title), static_cast<int>(row.index));
  kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  form->addRow(tr("Kind"), kind_);
  hint_->setProperty("role", "faint");
  hint_->setWordWrap(true);
  form->addRow(hint_);
  build_fields(form);
  connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
    show_fields();
    if (filling_)
      return;
    if (kind() == gravity && components_->value() == vec3{})
      components_->set_value({0, 0, -9.81});
    emit kind_changed();
  });
  show_fields();
}

void load_form::build_fields(QFormLayout* form) {
  components_ = new vector_field("component", tr("Component %1"), "N");
  scalar_ = new quantity_field("pressure", tr("Size"), "Pa");
  scalar_row_ = with_unit(scalar_);
  size_->setObjectName("size");
  size_->setProperty("role", "faint");
  auto* sizes = new QWidget;
  auto* column = new QVBoxLayout(sizes);
  column->setContentsMargins(0, 0, 0, 0);
  for (auto* part : std::initializer_list<QWidget*>{components_, scalar_row_, size_})
    column->addWidget(part);
  form->addRow(tr("Size"), sizes);
  by_place_ = new QCheckBox(tr("Changes by place, as under a liquid"));
  by_place_->setObjectName("by_place");
  form->addRow(by_place_);
  second_ = new vector_field("second", tr("Component %1"), "Pa/m");
  form->addRow(tr("Grows by"), second_);
  place_ = new vector_field("place", tr("Place %1"), "m");
  form->addRow(tr("At"), place_);

  for (auto* vector : {components_, second_, place_}) {
    connect(vector, &vector_field::changed, this, &load_form::show_size);
    connect(vector, &vector_field::accepted, this, &load_form::accepted);
  }
  connect(scalar_, &QLineEdit::textChanged, this, &load_form::show_size);
  connect(scalar_, &QLineEdit::returnPressed, this, &load_form::accepted);
  connect(by_place_, &QCheckBox::toggled, this, [this] {
    show_fields();
    show_size();
  });
}

void load_form::add_line_below(const char* field, QLabel* line) {
  auto* form = static_cast<QFormLayout*>(layout());
  auto* above = field == std::string_view("place")    ? static_cast<QWidget*>(place_)
                : field == std::string_view("second") ? static_cast<QWidget*>(second_)
                                                      : components_->parentWidget();
  int row = 0;
  QFormLayout::ItemRole role{};
  form->getWidgetPosition(above, &row, &role);
  form->insertRow(row + 1, QString(), line);
}

std::size_t load_form::kind() const {
  return static_cast<std::size_t>(kind_->currentData().toInt());
}

bool load_form::takes_surfaces() const {
  return kind() != gravity;
}

void load_form::show_fields() {
  const auto& row = row_of(kind());
  hint_->setText(*row.hint ? tr(row.hint) : QString());
  show_row(hint_, *row.hint != 0);
  (along_normal(kind()) ? scalar_->set_unit(row.unit) : components_->set_unit(row.unit));
  scalar_row_->findChild<QLabel*>()->setText(scalar_->unit_name());
  components_->setVisible(!along_normal(kind()));
  scalar_row_->setVisible(along_normal(kind()));
  const bool gradient = kind() == pressure && by_place_->isChecked();
  show_row(by_place_, kind() == pressure);
  show_row(second_, gradient || kind() == remote_force);
  show_row(place_, gradient || kind() == remote_force);
  second_->set_unit(gradient ? "Pa/m" : "N m");
  auto* label = static_cast<QLabel*>(static_cast<QFormLayout*>(layout())->labelForField(second_));
  label->setText(gradient ? tr("Grows by") : tr("Moment"));
  show_size();
}

void load_form::show_load(const fem::load& load) {
  filling_ = true;
  for (auto* vector : {components_, second_, place_})
    vector->set_value({});
  scalar_->set_value(0);
  by_place_->setChecked(false);
  kind_->setCurrentIndex(kind_->findData(static_cast<int>(load.kind.index())));
  show_fields();
  fill(load);
  filling_ = false;
  show_size();
}

void load_form::fill(const fem::load& load) {
  if (const auto* f = std::get_if<fem::force>(&load.kind))
    components_->set_value(f->total_n);
  else if (const auto* t = std::get_if<fem::traction>(&load.kind))
    components_->set_value(t->pa);
  else if (const auto* g = std::get_if<fem::gravity>(&load.kind))
    components_->set_value(g->m_s2);
  else if (const auto* n = std::get_if<fem::normal_force>(&load.kind))
    scalar_->set_value(n->total_n);
  else if (const auto* m = std::get_if<fem::moment>(&load.kind))
    components_->set_value(m->total_nm);
  else if (const auto* b = std::get_if<fem::bearing_force>(&load.kind))
    components_->set_value(b->total_n);
  else if (const auto* r = std::get_if<fem::remote_force>(&load.kind)) {
    components_->set_value(r->total_n);
    second_->set_value(r->moment_nm);
    place_->set_value(r->at_m);
  } else if (const auto* p = std::get_if<fem::pressure>(&load.kind)) {
    by_place_->setChecked(p->gradient_pa_m != vec3{});
    scalar_->set_value(p->pa);
    second_->set_value(p->gradient_pa_m);
    place_->set_value(p->at_m);
  }
}

fem::load load_form::read() const {
  const auto vector = components_->value();
  switch (kind()) {
    case traction:
      return {{}, fem::traction{vector}};
    case pressure:
      return by_place_->isChecked()
               ? fem::load{{}, fem::pressure{scalar_->value(), second_->value(), place_->value()}}
               : fem::load{{}, fem::pressure{scalar_->value()}};
    case gravity:
      return {{}, fem::gravity{vector}};
    case normal_force:
      return {{}, fem::normal_force{scalar_->value()}};
    case moment:
      return {{}, fem::moment{vector}};
    case remote_force:
      return {{}, fem::remote_force{vector, place_->value(), second_->value()}};
    case pin:
      return {{}, fem::bearing_force{vector}};
    default:
      return {{}, fem::force{vector}};
  }
}

void load_form::show_size() {
  const auto words = along_normal(kind()) ? QString() : components_->size_in_words();
  size_->setText(words);
  size_->setVisible(!words.isEmpty());
  if (!filling_)
    emit changed();
}

}  // namespace tedit::desktop
