// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results/field_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>
#include <cmath>
#include <utility>

#include "client-qt/model/field_values.hpp"
#include "client-qt/model/load_editing.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/typed_quantity.hpp"
#include "client-qt/tools/results/deformation_row.hpp"

namespace tedit::desktop {

namespace {

constexpr std::array<int, 4> band_choices{0, 8, 12, 16};

QWidget* side_by_side(std::initializer_list<QWidget*> parts) {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  for (auto* one : parts)
    row->addWidget(one, 1);
  return box;
}

/// Off where it would do nothing, and then its hint says why. Nothing to say: on, with the hint
/// that it had.
void enable(QWidget& one, const QString& why_not) {
  constexpr const char* usual = "usual_hint";
  if (!one.property(usual).isValid())
    one.setProperty(usual, one.toolTip());
  one.setEnabled(why_not.isEmpty());
  one.setToolTip(why_not.isEmpty() ? one.property(usual).toString() : why_not);
}

}  // namespace

field_panel::field_panel(document& part, QWidget* parent) : QWidget(parent), part_(part) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(12, 10, 12, 10);
  list_fields();
  case_ = new QComboBox;
  case_->setObjectName("load_case");
  map_ = new QComboBox;
  map_->setObjectName("colours");
  map_->addItems(
    {tr("Viridis"), tr("Cividis"), tr("Grey"), tr("Cool to warm"), tr("Safety steps")});
  bands_ = new QComboBox;
  bands_->setObjectName("bands");
  bands_->setToolTip(tr("Colours that flow, or steps of one colour each"));
  for (const int count : band_choices)
    bands_->addItem(count == 0 ? tr("Smooth") : tr("%1 bands").arg(count), count);
  isolines_ = new QCheckBox(tr("Isolines"));
  isolines_->setObjectName("isolines");
  isolines_->setToolTip(tr("Lines of equal value on the surface, at the edges of the bands"));
  missing_ = new QLabel;
  missing_->setObjectName("field_missing");
  missing_->setProperty("role", "faint");
  missing_->setWordWrap(true);
  missing_->hide();
  mode_ = new QComboBox;
  mode_->setObjectName("range_mode");
  mode_->addItems(
    {tr("99 % of the area"), tr("Full range"), tr("As typed"), tr("Locked across versions")});
  mode_->setItemData(
    0,
    tr("The hundredth of the surface with the largest values has the colour of the upper "
       "end: one hot corner leaves colours for the rest"),
    Qt::ToolTipRole);
  low_ = new QLineEdit;
  high_ = new QLineEdit;
  for (auto* edit : {low_, high_}) {
    edit->setMinimumWidth(60);
  }
  low_->setAccessibleName(tr("Lowest value"));
  high_->setAccessibleName(tr("Highest value"));
  log_ = new QCheckBox(tr("Logarithmic"));
  log_->setObjectName("logarithmic");
  deform_ = new deformation_row;
  form->addRow(tr("Field"), field_);
  form->addRow(missing_);
  form->addRow(tr("Load case"), case_);
  form->addRow(tr("Range"), mode_);
  form->addRow(QString(), side_by_side({low_, high_}));
  form->addRow(QString(), side_by_side({log_, isolines_}));
  form->addRow(tr("Colours"), side_by_side({map_, bands_}));
  form->addRow(tr("Deformation"), deform_);
  connect(field_, &QComboBox::currentIndexChanged, this, &field_panel::field_chosen);
  connect(case_, &QComboBox::currentIndexChanged, this, &field_panel::case_chosen);
  connect(map_, &QComboBox::currentIndexChanged, this, &field_panel::map_chosen);
  for (auto* box : {bands_, mode_})
    connect(box, &QComboBox::currentIndexChanged, this, &field_panel::read_form);
  for (auto* edit : {low_, high_})
    connect(edit, &QLineEdit::editingFinished, this, &field_panel::read_form);
  for (auto* box : {log_, isolines_})
    connect(box, &QCheckBox::toggled, this, &field_panel::read_form);
  connect(deform_, &deformation_row::changed, this, &field_panel::read_form);
  connect(&part_, &document::field_changed, this, &field_panel::list_cases);
  connect(&part_, &document::head_changed, this, &field_panel::list_cases);
  connect(&part_, &document::opened, this, [this] {
    to_lock_ = locks_;
    if (locks_)
      mode_->setCurrentIndex(static_cast<int>(range_mode::automatic));
  });
  show_row(*case_, false);
  field_chosen();
}

/// In groups; each says what it means.
void field_panel::list_fields() {
  field_ = new QComboBox;
  field_->setObjectName("field");
  field_->setMaxVisibleItems(24);
  for (const auto& group : field_groups()) {
    if (field_->count() > 0)
      field_->insertSeparator(field_->count());
    for (const auto one : group) {
      field_->addItem(field_title(one), one.row);
      field_->setItemData(field_->count() - 1, field_help(one), Qt::ToolTipRole);
    }
  }
}

/// The envelope has only what can be compared among load cases: another field shows the first one.
void field_panel::field_chosen() {
  const auto now = field();
  const auto wanted = shown_field{field_->currentData().toInt()};
  field_->setToolTip(field_help(wanted));
  if (now && now->envelope && !in_envelope(wanted)) {
    const QSignalBlocker quiet(case_);
    case_->setCurrentIndex(0);
  }
  {
    const QSignalBlocker quiet(map_);
    map_->setCurrentIndex(static_cast<int>(maps_[static_cast<std::size_t>(kind_of(wanted))]));
  }
  read_form();
}

void field_panel::case_chosen() {
  const auto now = field();
  if (now && now->envelope && !in_envelope(legend_.field))
    set_field(shown_field::von_mises);  // Comes to `read_form`.
  else
    read_form();
}

void field_panel::map_chosen() {
  maps_[static_cast<std::size_t>(kind_of(legend_.field))] =
    static_cast<colour_map>(map_->currentIndex());
  read_form();
}

bool field_panel::lacks_yield() const {
  const auto now = field();
  return now && legend_.field == shown_field::safety_factor && !has(*now, legend_.field) &&
         !(now->envelope ? now->envelope->min_safety_factor.has_value()
                         : now->report.min_safety_factor.has_value());
}

bool field_panel::is_on_its_way() const {
  const auto now = field();
  return now && !has(*now, legend_.field) && !lacks_yield();
}

/// Why the chosen quantity cannot be seen.
void field_panel::say_what_is_missing() {
  QString why;
  if (lacks_yield())
    why = tr("No yield strength is known: give the material one in \"Loads and supports\".");
  else if (is_on_its_way())
    why = tr("Loading: the server was asked for it.");
  missing_->setText(why);
  missing_->setVisible(!why.isEmpty());
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
    const bool any = in_envelope(legend_.field);
    case_->setCurrentIndex(same >= 0 ? same : any ? case_->count() - 1 : 0);
  }
  show_row(*case_, case_->count() > 1);
  enable_what_counts();
  say_what_is_missing();
  emit changed();
}

/// Of one load case there is nothing to choose, and the legend says a range that is not typed.
void field_panel::show_row(QWidget& field, bool on) {
  auto* form = static_cast<QFormLayout*>(layout());
  if (form->isRowVisible(&field) == on)
    return;
  form->setRowVisible(&field, on);
  emit height_changed();
}

shared_field field_panel::field() const {
  const auto* head = part_.head();
  const auto at = case_->currentIndex();
  if (!head || at < 0 || at >= static_cast<int>(head->fields.size()))
    return nullptr;
  return head->fields[static_cast<std::size_t>(at)];
}

double field_panel::deform() const {
  return deform_->factor();
}

void field_panel::set_field(shown_field field) {
  field_->setCurrentIndex(field_->findData(field.row));
}

void field_panel::set_case(const QString& name) {
  const int at = name.isEmpty() ? case_->count() - 1 : case_->findText(name);
  if (at >= 0)
    case_->setCurrentIndex(at);
}

QString field_panel::shown_case() const {
  const auto now = field();
  return now && !now->envelope ? QString::fromStdString(now->report.load_case) : QString();
}

bool field_panel::isolines() const {
  return isolines_->isChecked();
}

void field_panel::set_isolines(bool on) {
  isolines_->setChecked(on);
}

void field_panel::set_bands(int bands) {
  bands_->setCurrentIndex(std::max(0, bands_->findData(bands)));
}

void field_panel::set_deform(double factor) {
  deform_->set_factor(factor);
}

void field_panel::set_look(colour_map map, bool locked, bool logarithmic) {
  maps_[static_cast<std::size_t>(field_kind::magnitude)] = map;
  if (kind_of(legend_.field) == field_kind::magnitude)
    map_->setCurrentIndex(static_cast<int>(map));
  log_->setChecked(logarithmic);
  if (std::exchange(locks_, locked) != locked)
    mode_->setCurrentIndex(static_cast<int>(range_mode::automatic));
  to_lock_ = locked && follows_values();
}

void field_panel::read_form() {
  const auto before = legend_.field;
  legend_.field = shown_field{field_->currentData().toInt()};
  legend_.map = static_cast<colour_map>(map_->currentIndex());
  legend_.mode = static_cast<range_mode>(mode_->currentIndex());
  legend_.bands = bands_->currentData().toInt();
  enable_what_counts();
  legend_.logarithmic = log_->isChecked() && log_->isEnabled();
  if (legend_.field != before && !follows_values()) {
    mode_->setCurrentIndex(0);  // Another quantity: the old range means nothing. Comes back here.
    return;
  }
  if (low_->isEnabled()) {
    const double scale = shown_as(field_unit(legend_.field)).scale;
    const double low = read_number(low_->text()).value_or(NAN) / scale;
    const double high = read_number(high_->text()).value_or(NAN) / scale;
    if (high > low) {
      legend_.low = low;
      legend_.high = high;
    }
  }
  say_what_is_missing();
  emit changed();
}

/// What does nothing to what is shown now is off, and says why.
void field_panel::enable_what_counts() {
  const bool coloured = is_of_result(legend_.field);
  const bool is_safety = kind_of(legend_.field) == field_kind::safety;
  const QString plain =
    coloured ? QString() : tr("No result is shown: choose one above as the field");
  const QString steps = coloured && legend_.map == colour_map::safety
                          ? tr("The safety steps have the same colours everywhere")
                          : plain;
  for (auto* one : {mode_, bands_})
    enable(*one, steps);
  for (QWidget* one : std::initializer_list<QWidget*>{map_, isolines_})
    enable(*one, plain);
  enable(*log_, steps.isEmpty() && kind_of(legend_.field) == field_kind::has_sign
                  ? tr("Values with a sign have no logarithm")
                  : steps);
  const bool typed = steps.isEmpty() && legend_.mode == range_mode::manual;
  for (auto* edit : {low_, high_})
    edit->setEnabled(typed);
  show_row(*low_->parentWidget(), typed);
  const auto now = field();
  enable(*deform_, now && now->envelope
                     ? tr("The envelope of all load cases has no deformation: choose one of them")
                     : QString());
  constexpr auto safety = static_cast<int>(colour_map::safety);
  auto* steps_choice = static_cast<QStandardItemModel*>(map_->model())->item(safety);
  steps_choice->setEnabled(is_safety);
  steps_choice->setToolTip(is_safety ? QString() : tr("For the safety factor only"));
}

bool field_panel::follows_values() const {
  return legend_.mode == range_mode::automatic || legend_.mode == range_mode::full;
}

void field_panel::take_range(const legend& shown, bool has_values) {
  for (auto* edit : {low_, high_})
    edit->setPlaceholderText(!has_values && is_on_its_way() ? tr("loading") : QString());
  if (!follows_values())
    return;
  if (!has_values || shown.map == colour_map::safety) {  // The steps are those of the legend.
    low_->clear();
    high_->clear();
    return;
  }
  legend_.low = shown.low;
  legend_.high = shown.high;
  const double scale = shown_as(field_unit(shown.field)).scale;
  const double range = (shown.high - shown.low) * scale;
  low_->setText(number_in(shown.low * scale, range));
  high_->setText(number_in(shown.high * scale, range));
  const auto now = field();
  if (to_lock_ && now && !now->interim()) {
    to_lock_ = false;  // Later: the view is in the middle of painting.
    QMetaObject::invokeMethod(
      this, [this] { mode_->setCurrentIndex(static_cast<int>(range_mode::locked)); },
      Qt::QueuedConnection);
  }
}

}  // namespace tedit::desktop
