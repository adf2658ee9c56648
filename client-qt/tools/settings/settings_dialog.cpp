// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/settings/settings_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/language.hpp"

namespace tedit::desktop {

namespace {

QComboBox* choice(const char* name, const QStringList& items, int chosen) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->addItems(items);
  box->setCurrentIndex(chosen);
  return box;
}

}  // namespace

settings_dialog::settings_dialog(const preferences& now, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Settings"));
  setMinimumWidth(460);
  auto* column = new QVBoxLayout(this);
  auto* letters = new QLineEdit;
  letters->setObjectName("search");
  letters->setPlaceholderText(tr("Search the settings"));
  letters->setAccessibleName(letters->placeholderText());
  letters->setClearButtonEnabled(true);
  connect(letters, &QLineEdit::textChanged, this, &settings_dialog::search);
  column->addWidget(letters);
  content_ = new QWidget;
  auto* list = new QVBoxLayout(content_);
  list->setContentsMargins(0, 0, 0, 0);
  column->addWidget(content_);

  look_ =
    choice("look", {tr("As the system"), tr("Light"), tr("Dark")}, static_cast<int>(now.look));
  log_ = choice("log", {tr("Errors only"), tr("Errors and news"), tr("Everything")},
                static_cast<int>(now.log));
  auto* window = section(tr("Window"));
  add(window, tr("Colours of the window"), look_,
      tr("Light, dark, or as the system has it when the program starts"));
  build_language(window, now);
  turning_ = choice("turning", {tr("As a turntable: upright"), tr("As a ball: any way")},
                    static_cast<int>(now.turning));
  add(window, tr("A drag turns the part"), turning_,
      tr("Upright the z axis never tilts; any way the part can also be turned head over heels"));
  build_solver(now);
  build_legend(now);
  add(section(tr("Log")), tr("The log shows"), log_, tr("What is written to the log panel"));

  nothing_ = new QLabel(tr("No setting has these letters."));
  nothing_->setProperty("role", "faint");
  nothing_->hide();
  column->addWidget(nothing_);
  column->addStretch();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  column->addWidget(buttons);
  for (auto* box : {look_, language_, turning_, device_, order_, map_, range_, log_})
    connect(box, &QComboBox::currentIndexChanged, this, [this] { emit changed(values()); });
  connect(device_->lineEdit(), &QLineEdit::editingFinished, this,
          [this] { emit changed(values()); });
  connect(logarithmic_, &QCheckBox::toggled, this, [this] { emit changed(values()); });
  connect(tolerance_, &QDoubleSpinBox::valueChanged, this, [this] { emit changed(values()); });
}

QFormLayout* settings_dialog::section(const QString& title) {
  auto* box = new QGroupBox(title);
  content_->layout()->addWidget(box);
  sections_.push_back(box);
  return new QFormLayout(box);
}

void settings_dialog::add(QFormLayout* form, const QString& title, QWidget* field,
                          const QString& help) {
  auto* label = new QLabel(title);
  label->setBuddy(field);
  for (QWidget* one : {static_cast<QWidget*>(label), field}) {
    one->setToolTip(help);
    one->setWhatsThis(help);
  }
  field->setAccessibleName(title);
  form->addRow(label, field);
  const auto* box = qobject_cast<QGroupBox*>(form->parentWidget());
  entries_.push_back({label, field, box->title() + " " + title + " " + help});
}

/// A language that is wished for and not there stays wished for.
void settings_dialog::build_language(QFormLayout* form, const preferences& now) {
  language_ = choice("language", {tr("As the system")}, 0);
  language_->setItemData(0, QString());
  for (const auto& code : languages())
    language_->addItem(language_name(code), code);
  if (!now.language.isEmpty() && language_->findData(now.language) < 0)
    language_->addItem(now.language, now.language);
  language_->setCurrentIndex(std::max(0, language_->findData(now.language)));
  add(form, tr("Language"), language_, tr("Holds from the next start of the program"));
  auto* note = new QLabel(tr("Holds from the next start of the program"));
  note->setObjectName("language_note");
  note->setProperty("role", "faint");
  note->hide();
  form->addRow(note);
  connect(language_, &QComboBox::currentIndexChanged, note, &QWidget::show);
}

void settings_dialog::build_solver(const preferences& now) {
  device_ = choice("device", {tr("The server's choice"), "auto", "cpu", "lavapipe"}, 0);
  device_->setEditable(true);
  device_->setInsertPolicy(QComboBox::NoInsert);
  const int known = now.device.isEmpty() ? 0 : device_->findText(now.device);
  if (known < 0)
    device_->addItem(now.device);
  device_->setCurrentIndex(known < 0 ? device_->count() - 1 : known);
  order_ =
    choice("element_order", {tr("Linear tets: a quick look"), tr("Quadratic tets: accurate")},
           now.element_order - 1);
  tolerance_ = new QDoubleSpinBox;
  tolerance_->setObjectName("energy_tolerance");
  tolerance_->setRange(0, 50);
  tolerance_->setDecimals(1);
  tolerance_->setSuffix(" %");
  tolerance_->setSpecialValueText(tr("solve to the end"));
  tolerance_->setKeyboardTracking(false);
  tolerance_->setValue(100 * now.energy_tolerance);
  auto* form = section(tr("Solver"));
  add(form, tr("Device"), device_,
      tr("Where the stress is computed: auto, cpu, or a part of a device's name"));
  add(
    form, tr("Element order"), order_,
    tr("Linear tets are several times faster, but too stiff in bending: their stress is too low"));
  add(form, tr("Stop as a preview at"), tolerance_,
      tr("Stops at this estimated error in energy: less exact and faster"));
}

void settings_dialog::build_legend(const preferences& now) {
  map_ = choice("map", {tr("Viridis"), tr("Cividis"), tr("Grey"), tr("Cool to warm")},
                static_cast<int>(now.map));
  range_ = choice("range",
                  {tr("Automatic, anew with each field"), tr("Locked to that of the first field")},
                  now.locked ? 1 : 0);
  logarithmic_ = new QCheckBox;
  logarithmic_->setObjectName("logarithmic");
  logarithmic_->setChecked(now.logarithmic);
  auto* form = section(tr("Legend"));
  add(form, tr("Colours"), map_, tr("The scale that a field is drawn with"));
  add(form, tr("Range"), range_,
      tr("From where to where the colours go; locked, versions can be compared by colour"));
  add(form, tr("Logarithmic"), logarithmic_, tr("Equal factors get equal room on the scale"));
}

preferences settings_dialog::values() const {
  preferences result;
  result.look = static_cast<look_wish>(look_->currentIndex());
  result.language = language_->currentData().toString();
  result.turning = static_cast<turning_wish>(turning_->currentIndex());
  const QString device = device_->currentText().trimmed();
  result.device = device == device_->itemText(0) ? QString() : device;
  result.element_order = order_->currentIndex() + 1;
  result.energy_tolerance = tolerance_->value() / 100;
  result.map = static_cast<colour_map>(map_->currentIndex());
  result.locked = range_->currentIndex() == 1;
  result.logarithmic = logarithmic_->isChecked();
  result.log = static_cast<log_level>(log_->currentIndex());
  return result;
}

void settings_dialog::search(const QString& letters) {
  bool any = false;
  for (auto* box : sections_)
    box->hide();
  for (const auto& one : entries_) {
    const bool fits = one.words.contains(letters.trimmed(), Qt::CaseInsensitive);
    one.label->setVisible(fits);
    one.field->setVisible(fits);
    if (fits)
      one.field->parentWidget()->show();
    any = any || fits;
  }
  nothing_->setVisible(!any);
}

}  // namespace tedit::desktop
