// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/printing/print_panel.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <array>
#include <cmath>

#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/loads/quantity_fields.hpp"
#include "client-qt/widgets/tall_scroll.hpp"

namespace tedit::desktop {

namespace {

constexpr double usual_wall = 1e-3;
constexpr double thickest_wall = 1e3;
constexpr double thinnest_wall = 1e-9;
constexpr int form_width = 300;
enum print_columns { found_column, value_column };

/// Entries of the list of directions.
const std::array<vec3, 6> axes{vec3{0, 0, 1},  vec3{0, 0, -1}, vec3{1, 0, 0},
                               vec3{-1, 0, 0}, vec3{0, 1, 0},  vec3{0, -1, 0}};
constexpr int off_wall = static_cast<int>(axes.size());
constexpr int of_its_own = off_wall + 1;

/// A square of a mark's colour and what it means.
QString mark_words(print_mark mark, const QString& words) {
  const auto [red, green, blue] = print_mark_colours[static_cast<std::size_t>(mark)];
  return QString::fromUtf8("<span style=\"color:%1\">■</span>&nbsp;%2")
    .arg(QColor(red, green, blue).name(), words);
}

}  // namespace

print_panel::print_panel(document& part, const selection& picked, print_inspection& inspection,
                         QWidget* parent)
    : QWidget(parent), part_(part), picked_(picked), inspection_(inspection) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  auto* both = new QSplitter;
  both->addWidget(new tall_scroll(make_form()));
  both->addWidget(make_found());
  both->setStretchFactor(1, 1);
  both->setSizes({form_width, 2 * form_width});
  row->addWidget(both);
  set_settings({.thinner_than = usual_wall});
  connect(&inspection_, &print_inspection::changed, this, &print_panel::refresh);
  connect(&part_, &document::head_changed, this, &print_panel::refresh_state);
  connect(&part_, &document::closed, this, &print_panel::refresh_state);
  refresh();
}

QWidget* print_panel::make_form() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(8, 4, 8, 4);
  auto* form = new QFormLayout;
  wall_ = new quantity_field("print_wall", tr("Least wall thickness"), "m");
  wall_->setPlaceholderText(tr("not looked for"));
  lean_ = new quantity_field("print_lean", tr("Largest overhang"), "rad");
  lean_->setToolTip(tr("From the build direction: 0 is an upright wall, 90 a ceiling"));
  direction_ = new QComboBox;
  direction_->setObjectName("print_direction");
  direction_->setAccessibleName(tr("Build direction"));
  direction_->addItems({tr("z"), tr("z, downwards"), tr("x"), tr("x, backwards"), tr("y"),
                        tr("y, backwards"), tr("Off the selected flat wall")});
  direction_->setToolTip(tr("From the plate on"));
  form->addRow(tr("Least wall"), with_unit(wall_));
  form->addRow(tr("Overhang"), with_unit(lean_));
  form->addRow(tr("Build direction"), direction_);
  column->addLayout(form);
  button_ = new QPushButton;
  button_->setObjectName("print_check");
  column->addWidget(button_);
  state_ = new QLabel;
  state_->setObjectName("print_state");
  state_->setWordWrap(true);
  column->addWidget(state_);
  column->addStretch();
  for (auto* field : {wall_, lean_})
    connect(field, &QLineEdit::returnPressed, this, &print_panel::check);
  connect(button_, &QPushButton::clicked, this, [this] {
    if (inspection_.is_asking())
      inspection_.cancel();
    else
      check();
  });
  return box;
}

QWidget* print_panel::make_found() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(4, 4, 8, 4);
  list_ = new QTreeWidget;
  list_->setObjectName("print_found");
  list_->setAccessibleName(tr("What was found"));
  list_->setColumnCount(2);
  list_->setHeaderHidden(true);
  list_->setAllColumnsShowFocus(true);
  list_->setIndentation(14);
  // What was found is whole; names of surfaces make room for it.
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(value_column, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(found_column, QHeaderView::Stretch);
  column->addWidget(list_, 1);
  colours_ = new QLabel(mark_words(print_mark::thin, tr("thin")) + "&nbsp;&nbsp; " +
                        mark_words(print_mark::overhang, tr("overhanging")) + "&nbsp;&nbsp; " +
                        mark_words(print_mark::both, tr("both")));
  colours_->setObjectName("print_colours");
  column->addWidget(colours_);
  const auto go_to = [this](const QTreeWidgetItem* item) {
    if (const auto* place = place_of(item))
      emit place_wanted(*place->at, place->surfaces);
  };
  connect(list_, &QTreeWidget::itemClicked, this, go_to);
  connect(list_, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
    if (const auto* place = place_of(item))
      emit surfaces_wanted(place->surfaces);
  });
  return box;
}

void print_panel::set_settings(const print_settings& settings) {
  if (settings.thinner_than > 0)
    wall_->set_value(settings.thinner_than);
  else
    wall_->clear();
  lean_->set_value(settings.lean);
  direction_->removeItem(of_its_own);
  const vec3 up = settings.up / norm(settings.up);
  const auto axis = std::ranges::find(axes, up);
  if (axis == axes.end()) {
    own_direction_ = up;
    direction_->addItem(side_by_side({number(up.x), number(up.y), number(up.z)}));
  }
  direction_->setCurrentIndex(axis == axes.end() ? of_its_own
                                                 : static_cast<int>(axis - axes.begin()));
}

std::optional<vec3> print_panel::direction() const {
  const int chosen = direction_->currentIndex();
  if (chosen == of_its_own)
    return own_direction_;
  if (chosen != off_wall)
    return axes[static_cast<std::size_t>(chosen)];
  const auto* head = part_.head();
  return head && head->surface ? up_from(*head->surface, picked_.surfaces()) : std::nullopt;
}

std::optional<print_settings> print_panel::read_form() {
  print_settings settings;
  settings.thinner_than = wall_->text().trimmed().isEmpty() ? 0 : wall_->value();
  settings.lean = lean_->value();
  const bool wall_is_good = settings.thinner_than == 0 || (settings.thinner_than >= thinnest_wall &&
                                                           settings.thinner_than <= thickest_wall);
  if (!wall_is_good) {
    say(tr("The least wall is a length, as 1.2; empty: thin walls are not looked for."));
    return std::nullopt;
  }
  // 90 degrees that were typed may be more than a quarter turn by rounding.
  if (!(settings.lean >= 0 && settings.lean <= 90.000001 * degree)) {
    say(tr("The overhang is an angle from 0° (an upright wall) to 90° (a ceiling)."));
    return std::nullopt;
  }
  settings.lean = std::min(settings.lean, 90 * degree);
  const auto up = direction();
  if (!up) {
    say(tr("Select one flat wall: it lies on the plate, and the part is built away from it."));
    return std::nullopt;
  }
  settings.up = *up;
  return settings;
}

void print_panel::check() {
  if (const auto settings = read_form())
    inspection_.look(*settings);
}

void print_panel::say(const QString& text) {
  state_->setText(text);
}

void print_panel::refresh() {
  rows_.clear();
  if (const auto& known = inspection_.known())
    rows_ = print_rows(*known, [this](surface_id id) { return part_.surface_name(id); });
  list_->clear();
  for (const auto& row : rows_)
    add_row(nullptr, row);
  list_->expandAll();
  colours_->setVisible(inspection_.known() && !inspection_.known()->facets.empty());
  refresh_state();
}

void print_panel::refresh_state() {
  button_->setText(inspection_.is_asking() ? tr("Cancel") : tr("Check"));
  button_->setEnabled(part_.head() != nullptr);
  if (inspection_.is_asking())
    say(tr("Checking ..."));
  else if (const auto& refusal = inspection_.refusal())
    say(sentence_of(refusal->message));
  else if (const auto& known = inspection_.known())
    say(known->what.has_findings()
          ? tr("Something in version %1 hinders printing.").arg(known->version)
          : tr("Nothing in version %1 hinders printing.").arg(known->version));
  else
    say({});
}

void print_panel::add_row(QTreeWidgetItem* parent, const print_row& row) {
  auto* item = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(list_);
  item->setText(found_column, row.title);
  item->setText(value_column, row.value);
  item->setToolTip(found_column, row.title);
  if (row.fault && !row.at) {
    auto bold = item->font(value_column);
    bold.setBold(true);
    item->setFont(value_column, bold);
  }
  if (row.at)
    item->setToolTip(value_column, tr("A click turns the view there, Enter picks the surfaces"));
  for (const auto& place : row.places)
    add_row(item, place);
}

const print_row* print_panel::place_of(const QTreeWidgetItem* item) const {
  if (!item || !item->parent())
    return nullptr;
  const auto row = static_cast<std::size_t>(list_->indexOfTopLevelItem(item->parent()));
  const auto place =
    static_cast<std::size_t>(item->parent()->indexOfChild(const_cast<QTreeWidgetItem*>(item)));
  const auto& found = rows_[row].places[place];
  return found.at ? &found : nullptr;
}

}  // namespace tedit::desktop
