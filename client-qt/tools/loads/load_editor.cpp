// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/load_editor.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMetaProperty>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/tools/loads/load_form.hpp"
#include "client-qt/tools/loads/quantity_fields.hpp"
#include "client-qt/widgets/tall_scroll.hpp"

namespace tedit::desktop {

namespace {

/// Words that get the height that they need at their width: a form in a form does not give it.
class wrapped_label : public QLabel {
public:
  wrapped_label() { setWordWrap(true); }

  void show_words(const QString& words) {
    setText(words);
    setMinimumHeight(words.isEmpty() ? 0 : heightForWidth(width()));
  }

protected:
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    show_words(text());
  }
};

}  // namespace

load_item first_item(item_kind kind, const std::vector<surface_id>& picked) {
  if (kind == item_kind::material)
    return fem::material{"Steel S235", 210e9, 0.3, 7850, 235e6, {}};  // The library's first.
  if (kind == item_kind::support)
    return fem::constraint{picked, fem::fixed{}};
  return fem::load{picked, fem::force{}};
}

load_editor::load_editor(std::vector<fem::material> library, QWidget* parent)
    : QWidget(parent), library_(std::move(library)) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 8, 12, 4);
  title_ = new QLabel;
  title_->setProperty("role", "section");
  column->addWidget(title_);
  build_material();
  build_support();
  build_load();
  for (auto* page : pages_)
    column->addWidget(page);

  picked_ = new QLabel;
  picked_->setObjectName("picked");
  picked_->setWordWrap(true);
  picking_ = row_of({picked_});
  column->addWidget(picking_);
  column->addWidget(fault_label("surfaces"));
  column->addStretch();
  scroll_ = new tall_scroll(content);

  apply_ = new QPushButton(tr("Apply"));
  apply_->setObjectName("apply_item");
  apply_->setProperty("role", "primary");
  connect(apply_, &QPushButton::clicked, this, [this] {
    if (value())
      emit applied();
  });
  auto* close = new QPushButton(tr("Cancel"));
  close->setObjectName("close_item");
  connect(close, &QPushButton::clicked, this, &load_editor::closed);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(12, 0, 12, 8);
  buttons->addWidget(apply_);
  buttons->addWidget(close);
  buttons->addStretch();
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scroll_, 1);
  all->addLayout(buttons);
  edit(tr("New load"), fem::load{{}, fem::force{}});
}

// -- building ------------------------------------------------------------------------

QLabel* load_editor::fault_label(const char* field) {
  auto* label = new wrapped_label;
  label->setObjectName(QString("fault_") + field);
  label->setProperty("role", "fault");
  label->hide();
  fault_labels_[field].push_back(label);
  return label;
}

QLineEdit* load_editor::watched(QLineEdit* field, const char* name, const QString& accessible) {
  field->setObjectName(name);
  field->setAccessibleName(accessible);
  connect(field, &QLineEdit::textChanged, this, &load_editor::touched);
  connect(field, &QLineEdit::returnPressed, this, [this] { apply_->click(); });
  return field;
}

quantity_field* load_editor::number_field(const char* name, const QString& accessible,
                                          const char* unit) {
  auto* field = new quantity_field(name, accessible, unit);
  watched(field, name, field->accessibleName());
  return field;
}

QWidget* load_editor::row_of(const std::vector<QWidget*>& parts) {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  for (auto* part : parts)
    row->addWidget(part, qobject_cast<QLineEdit*>(part) || part == picked_ ? 1 : 0);
  return box;
}

void load_editor::add_row(QFormLayout* form, const QString& title, QWidget* field,
                          const char* fault) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  column->addWidget(field);
  column->addWidget(fault_label(fault));
  auto* label = new QLabel(title);
  label->setBuddy(field);
  form->addRow(label, box);
}

QFormLayout* load_editor::new_page(item_kind kind) {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  pages_[static_cast<std::size_t>(kind)] = page;
  return form;
}

void load_editor::build_material() {
  auto* form = new_page(item_kind::material);
  library_box_ = new QComboBox;
  library_box_->setObjectName("library");
  library_box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  library_box_->addItem(tr("Own values"));
  for (const auto& one : library_)
    library_box_->addItem(QString::fromStdString(one.name));
  library_box_->setToolTip(tr("Typical values; take those of your data sheet for a real design"));
  connect(library_box_, &QComboBox::currentIndexChanged, this, &load_editor::take_library);
  form->addRow(tr("From"), library_box_);
  name_ = watched(new QLineEdit, "name", tr("Name of the material"));
  add_row(form, tr("Name"), name_, "name");
  young_ = number_field("young_modulus", tr("Young's modulus"), "Pa");
  add_row(form, tr("E"), with_unit(young_), "young_modulus");
  poisson_ = number_field("poisson_ratio", tr("Poisson's ratio"), "");
  add_row(form, QString::fromUtf8("ν"), with_unit(poisson_), "poisson_ratio");
  density_ = number_field("density", tr("Density"), "kg/m3");
  add_row(form, tr("Density"), with_unit(density_), "density");
  yield_ = number_field("yield_strength", tr("Yield strength"), "Pa");
  add_row(form, tr("Yield"), with_unit(yield_), "yield_strength");
  regions_ = watched(new QLineEdit, "regions", tr("Regions of the mesh"));
  regions_->setPlaceholderText(tr("all that no other material names"));
  add_row(form, tr("Regions"), regions_, "regions");
}

void load_editor::build_support() {
  auto* form = new_page(item_kind::support);
  support_kind_ = new QComboBox;
  support_kind_->setObjectName("support_kind");
  support_kind_->addItems({tr("Fixed"), tr("Displaced by ..."), tr("Roller: slides, no lifting")});
  form->addRow(tr("Kind"), support_kind_);
  displacements_ = new QWidget;
  auto* rows = new QFormLayout(displacements_);
  rows->setContentsMargins(0, 0, 0, 0);
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    held_[i] = new QCheckBox(axes[i]);
    held_[i]->setObjectName(QString("held_") + axes[i]);
    held_[i]->setToolTip(tr("Not ticked: free to move this way"));
    moved_[i] = number_field((std::string("moved_") + axes[i]).c_str(),
                             tr("Displacement %1").arg(axes[i]), "m");
    connect(held_[i], &QCheckBox::toggled, moved_[i], &QWidget::setEnabled);
    connect(held_[i], &QCheckBox::toggled, this, &load_editor::touched);
    rows->addRow(held_[i], with_unit(moved_[i]));
  }
  add_row(form, QString(), displacements_, "components");
  connect(support_kind_, &QComboBox::currentIndexChanged, this, [this](int row) {
    displacements_->parentWidget()->setVisible(row == 1);
    check();
  });
}

void load_editor::build_load() {
  load_ = new load_form;
  pages_[static_cast<std::size_t>(item_kind::load)] = load_;
  for (const auto* field : {"place", "second", "components"})
    load_->add_line_below(field, fault_label(field));
  connect(load_, &load_form::changed, this, &load_editor::touched);
  connect(load_, &load_form::accepted, this, [this] { apply_->click(); });
  connect(load_, &load_form::kind_changed, this, [this] {
    if (surfaces_.empty() && takes_surfaces())
      surfaces_ = selection_;
    show_surfaces();
    check();
  });
}

// -- showing -------------------------------------------------------------------------

void load_editor::edit(const QString& title, const load_item& item) {
  filling_ = true;
  touched_ = false;
  title_->setText(title);
  kind_ = kind_of(item);
  for (std::size_t i = 0; i < pages_.size(); ++i)
    pages_[i]->setVisible(i == static_cast<std::size_t>(kind_));
  surfaces_.clear();
  if (const auto* material = std::get_if<fem::material>(&item))
    show_material(*material);
  else if (const auto* support = std::get_if<fem::constraint>(&item))
    show_support(*support);
  else if (const auto* load = std::get_if<fem::load>(&item)) {
    surfaces_ = load->surfaces;
    load_->show_load(*load);
  }
  show_surfaces();
  filling_ = false;
  check();
  scroll_->updateGeometry();  // Another page is of another height.
}

void load_editor::show_material(const fem::material& material) {
  const auto same = std::ranges::find(library_, material.name, &fem::material::name);
  library_box_->setCurrentIndex(
    same == library_.end() ? 0 : 1 + static_cast<int>(same - library_.begin()));
  name_->setText(QString::fromStdString(material.name));
  young_->set_value(material.young_modulus_pa);
  poisson_->set_value(material.poisson_ratio);
  density_->set_value(material.density_kg_m3);
  yield_->set_value(material.yield_strength_pa);
  QStringList regions;
  for (const auto region : material.regions)
    regions << QString::number(region);
  regions_->setText(regions.join(", "));
}

void load_editor::take_library(int row) {
  if (filling_ || row <= 0)
    return;
  auto chosen = library_[static_cast<std::size_t>(row - 1)];
  chosen.regions = read_regions(regions_->text()).value_or(std::vector<region_id>{});
  filling_ = true;
  show_material(chosen);
  filling_ = false;
  check();
}

void load_editor::show_support(const fem::constraint& support) {
  surfaces_ = support.surfaces;
  support_kind_->setCurrentIndex(static_cast<int>(support.kind.index()));
  displacements_->parentWidget()->setVisible(support.kind.index() == 1);
  const auto* given = std::get_if<fem::prescribed_displacement>(&support.kind);
  const std::array<std::optional<double>, 3> parts =
    given ? std::array{given->x_m, given->y_m, given->z_m}
          : std::array<std::optional<double>, 3>{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    held_[i]->setChecked(parts[i].has_value());
    moved_[i]->setEnabled(parts[i].has_value());
    moved_[i]->set_value(parts[i].value_or(0));
  }
}

void load_editor::set_selection(const std::vector<surface_id>& picked) {
  selection_ = picked;
  if (takes_surfaces())
    surfaces_ = picked;
  show_surfaces();
  check();
}

bool load_editor::takes_surfaces() const {
  return kind_ == item_kind::support || (kind_ == item_kind::load && load_->takes_surfaces());
}

void load_editor::show_surfaces() {
  picking_->setVisible(takes_surfaces());
  QStringList ids;
  for (const auto id : surfaces_)
    ids << QString::number(id);
  const QString shown = ids.mid(0, 6).join(", ") + (ids.size() > 6 ? ", ..." : "");
  picked_->setText(ids.isEmpty() ? tr("No surfaces yet: click them, Shift adds")
                                 : tr("Surfaces: %1").arg(shown));
  picked_->setToolTip(
    tr("Click surfaces of the part; Shift adds. %1").arg(ids.join(", ")).trimmed());
}

// -- reading -------------------------------------------------------------------------

load_item load_editor::read() const {
  if (kind_ == item_kind::material) {
    fem::material result;
    result.name = name_->text().trimmed().toStdString();
    result.young_modulus_pa = young_->value();
    result.poisson_ratio = poisson_->value();
    result.density_kg_m3 = density_->value();
    result.yield_strength_pa = yield_->value();
    result.regions = read_regions(regions_->text()).value_or(std::vector<region_id>{});
    return result;
  }
  if (kind_ == item_kind::support) {
    fem::constraint result{surfaces_, fem::fixed{}};
    const auto part = [&](std::size_t i) {
      return held_[i]->isChecked() ? std::optional(moved_[i]->value()) : std::nullopt;
    };
    if (support_kind_->currentIndex() == 1)
      result.kind = fem::prescribed_displacement{part(0), part(1), part(2)};
    else if (support_kind_->currentIndex() == 2)
      result.kind = fem::roller{};
    return result;
  }
  auto result = load_->read();
  if (load_->takes_surfaces())
    result.surfaces = surfaces_;
  return result;
}

std::vector<item_fault> load_editor::faults_now() const {
  auto found = faults(read());
  if (kind_ == item_kind::material && !read_regions(regions_->text()))
    found.push_back({"regions", tr("Give numbers of regions, with commas between")});
  return found;
}

std::optional<load_item> load_editor::value() const {
  return faults_now().empty() ? std::optional(read()) : std::nullopt;
}

/// Those that are shown; what others hang on comes first.
std::vector<QWidget*> load_editor::fields() const {
  const auto* page = pages_[static_cast<std::size_t>(kind_)];
  std::vector<QWidget*> result;
  for (auto* one : page->findChildren<QComboBox*>())
    result.push_back(one);
  for (auto* one : page->findChildren<QCheckBox*>())
    result.push_back(one);
  for (auto* one : page->findChildren<QLineEdit*>())
    result.push_back(one);
  return result;
}

std::optional<typed_item> load_editor::typed() const {
  if (!touched_)
    return std::nullopt;
  typed_item result{{}, surfaces_};
  for (const auto* one : fields())
    result.fields.push_back(one->metaObject()->userProperty().read(one));
  return result;
}

void load_editor::take_up(const typed_item& before) {
  const auto all = fields();
  filling_ = true;
  for (std::size_t i = 0; i < std::min(all.size(), before.fields.size()); ++i)
    all[i]->metaObject()->userProperty().write(all[i], before.fields[i]);
  filling_ = false;
  touched_ = true;
  show_surfaces();
  check();
}

void load_editor::touched() {
  if (!filling_)
    touched_ = true;
  check();
}

void load_editor::check() {
  if (filling_)
    return;
  const auto found = faults_now();
  for (const auto& [field, labels] : fault_labels_) {
    const auto fault = std::ranges::find(found, field, &item_fault::field);
    for (auto* label : labels) {
      label->setProperty("role", touched_ ? "fault" : "faint");
      label->style()->unpolish(label);
      label->style()->polish(label);
      static_cast<wrapped_label*>(label)->show_words(fault == found.end() ? QString()
                                                                          : fault->words);
      label->setVisible(fault != found.end() &&
                        (field != "surfaces" || picking_->isVisibleTo(this)));
    }
  }
  apply_->setEnabled(found.empty());
}

}  // namespace tedit::desktop
