// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/loads_panel.hpp"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/materials.hpp"
#include "client-qt/model/server_words.hpp"
#include "client-qt/widgets/theme.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

namespace {

enum role { surfaces_role = Qt::UserRole, case_role, kind_role, at_role };

constexpr int roomy_window = 850;  // Pixels: below, the editor takes the place of the tree.
constexpr const char* drawings[] = {"material", "support", "load"};

}  // namespace

loads_panel::loads_panel(document& part, selection& picked, QWidget* parent)
    : QWidget(parent), part_(part), picked_(picked) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  build_buttons();
  column->addWidget(buttons_);
  tree_ = new QTreeWidget;
  tree_->setHeaderHidden(true);
  tree_->setAccessibleName(tr("Load cases"));
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  column->addWidget(tree_, 1);
  hint_ = new QLabel;
  hint_->setObjectName("draft_hint");
  hint_->setProperty("role", "faint");
  hint_->setWordWrap(true);
  hint_->setContentsMargins(12, 4, 12, 4);
  column->addWidget(hint_);
  const auto library = shipped_materials();
  editor_ = new load_editor(library ? *library : std::vector<fem::material>{});
  if (!library)
    editor_->findChild<QComboBox*>("library")->setToolTip(one_line(library.error()));
  editor_->hide();
  column->addWidget(editor_);
  column->addStretch();
  wire();
  refresh();
}

void loads_panel::build_buttons() {
  buttons_ = new QWidget;
  auto* row = new QHBoxLayout(buttons_);
  row->setContentsMargins(8, 4, 8, 4);
  const auto add = [&](const QString& text, const char* name, const QString& help, auto then) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setProperty("role", "link");
    button->setToolTip(help);
    connect(button, &QPushButton::clicked, this, then);
    row->addWidget(button);
  };
  add(tr("+ Support"), "add_support", tr("Hold the surfaces that are picked"),
      [this] { add_item(item_kind::support); });
  add(tr("+ Load"), "add_load", tr("Load the surfaces that are picked"),
      [this] { add_item(item_kind::load); });
  add(tr("+ Material"), "add_material", tr("What the part is made of"),
      [this] { add_item(item_kind::material); });
  add(tr("+ Load case"), "add_case", tr("Another set of materials, supports and loads"),
      [this] { new_load_case(); });
  row->addStretch();
}

void loads_panel::wire() {
  connect(editor_, &load_editor::applied, this, &loads_panel::apply_editor);
  connect(editor_, &load_editor::closed, this, &loads_panel::cancel);
  connect(&picked_, &selection::changed, this, [this] {
    if (editing_)
      editor_->set_selection(picked_.surfaces());
  });
  for (auto signal : {&document::head_changed, &document::opened})
    connect(&part_, signal, this, &loads_panel::refresh);
  connect(&part_.loads(), &load_requests::changed, this, [this] {
    forget_settled_drafts();
    refresh();
  });
  connect(&part_, &document::edited, this, &loads_panel::carry_drafts);
  connect(&part_, &document::begun, this, [this] {
    drafts_.clear();
    cancel();
    unfinished_.clear();
    refresh();
  });
  connect(tree_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
    const auto list = item->data(0, surfaces_role).value<QList<qint64>>();
    if (!list.isEmpty() && !editing_)  // Else the open form would take them.
      emit surfaces_wanted(list);
  });
  connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this] {
    if (const auto place = current())
      edit_row(*place);
  });
  connect(tree_, &QTreeWidget::customContextMenuRequested, this, &loads_panel::show_menu);
  connect(tree_, &QTreeWidget::itemChanged, this, &loads_panel::renamed);
  connect(tree_, &QTreeWidget::currentItemChanged, this, [this] {
    if (!filling_)
      emit chosen_changed();
  });
}

// -- the tree ------------------------------------------------------------------------

/// The same only: a later change may be on its way. One that has come back, as by undo, is meant.
void loads_panel::forget_settled_drafts() {
  const auto& now = part_.loads().all();
  std::erase_if(drafts_, [&](const fem::load_case& one) {
    const auto* known = find(one.name, now);
    const bool is_back = !known_.contains(one.name) && !missing(one).isEmpty();
    return known &&
           (is_back || protocol::load_case_to_json(*known) == protocol::load_case_to_json(one));
  });
  known_.clear();
  for (const auto& one : now)
    known_.insert(one.name);
}

/// Those of the head; drafts stand for the ones of their names.
std::vector<fem::load_case> loads_panel::all() const {
  auto result = part_.loads().all();
  for (const auto& draft : drafts_)
    put(result, draft);
  return result;
}

const fem::load_case* loads_panel::find(const std::string& name,
                                        const std::vector<fem::load_case>& in) const {
  const auto found = std::ranges::find(in, name, &fem::load_case::name);
  return found == in.end() ? nullptr : &*found;
}

void loads_panel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && editor_)
    refresh();
}

void loads_panel::refresh() {
  const auto before = current();
  filling_ = true;
  tree_->clear();
  const auto cases = all();
  for (const auto& one : cases)
    add_case(one);
  const auto* head = part_.head();
  QStringList lines;
  for (const auto& draft : drafts_) {
    const QString name = QString::fromStdString(draft.name);
    const QString lacks = missing(draft);
    lines << (lacks.isEmpty() ? tr("%1 has changes that the server has not taken yet.").arg(name)
                              : tr("%1 is not solved yet; it still needs %2.").arg(name, lacks));
  }
  for (const auto& name : head ? head->info.load_cases : std::vector<std::string>{})
    if (!find(name, cases))
      lines << tr(
                 "%1 is solved too. It was set before this window opened the document, so its "
                 "items are not known here.")
                 .arg(QString::fromStdString(name));
  if (cases.empty() && lines.isEmpty())
    lines << tr("No loads yet. Pick surfaces of the part, then add a support and a load.");
  hint_->setText(lines.join("\n"));
  show_parts();
  buttons_->setEnabled(head != nullptr);
  for (QTreeWidgetItemIterator at(tree_); before && *at; ++at)
    if ((*at)->data(0, case_role).toString().toStdString() == before->load_case &&
        (*at)->data(0, kind_role).toInt() ==
          (before->kind ? static_cast<int>(*before->kind) : -1) &&
        (*at)->data(0, at_role).toULongLong() == before->at)
      tree_->setCurrentItem(*at);
  filling_ = false;
  emit drafts_changed();
  emit chosen_changed();
}

void loads_panel::add_case(const fem::load_case& loads) {
  auto* top = new QTreeWidgetItem(tree_, {QString::fromStdString(loads.name)});
  top->setFlags(top->flags() | Qt::ItemIsEditable);
  top->setData(0, case_role, QString::fromStdString(loads.name));
  top->setData(0, kind_role, -1);
  top->setExpanded(true);
  if (find(loads.name, drafts_)) {
    auto font = top->font(0);
    font.setItalic(true);
    top->setFont(0, font);
  }
  const auto* head = part_.head();
  const auto changed =
    head && head->report ? marks(*head->report, loads.name) : std::vector<item_mark>{};
  for (const auto kind : {item_kind::material, item_kind::support, item_kind::load})
    for (std::size_t i = 0; i < count_of(loads, kind); ++i)
      add_row(top, item_at(loads, kind, i), {loads.name, kind, i}, changed);
  add_dropped(top, changed);
}

void loads_panel::add_row(QTreeWidgetItem* parent, const load_item& item, const row_place& place,
                          const std::vector<item_mark>& changed) {
  auto* row = new QTreeWidgetItem(parent, {words(item)});
  const auto ids = surfaces_of(item);
  row->setIcon(0, icon(drawings[item.index()], palette().color(QPalette::WindowText)));
  row->setData(0, surfaces_role, QVariant::fromValue(QList<qint64>(ids.begin(), ids.end())));
  row->setData(0, case_role, QString::fromStdString(place.load_case));
  row->setData(0, kind_role, static_cast<int>(*place.kind));
  row->setData(0, at_role, static_cast<qulonglong>(place.at));
  QStringList help;
  for (const auto& mark : changed)
    if (mark.kind == *place.kind && mark.at == place.at) {
      const bool lost = mark.fate == fem::receipt_fate::reduced;
      row->setIcon(0,
                   icon(lost ? "warning" : "info", lost ? QColor("#b26a00") : QColor("#2f7fc1")));
      row->setText(0, row->text(0) + (lost ? tr("  · reduced") : tr("  · area changed")));
      help << mark.text;
    }
  if (!ids.empty())
    help << tr("Surfaces: %1").arg(ids.size());
  help << tr("Double-click to change it");
  row->setToolTip(0, help.join("\n"));
}

/// What the edit took away stays to be seen until the next one.
void loads_panel::add_dropped(QTreeWidgetItem* parent, const std::vector<item_mark>& changed) {
  for (const auto& mark : changed) {
    if (mark.fate != fem::receipt_fate::dropped)
      continue;
    auto* row = new QTreeWidgetItem(
      parent, {mark.kind == item_kind::support ? tr("Support dropped") : tr("Load dropped")});
    row->setFlags(Qt::ItemIsEnabled);
    row->setIcon(0, icon("warning", QColor("#c62828")));
    row->setToolTip(0, mark.text);
    row->setData(0, kind_role, -2);
    auto font = row->font(0);
    font.setStrikeOut(true);
    row->setFont(0, font);
  }
}

std::optional<loads_panel::row_place> loads_panel::current() const {
  const auto* row = tree_->currentItem();
  if (!row || row->data(0, kind_role).toInt() < -1)
    return std::nullopt;
  row_place place;
  place.load_case = row->data(0, case_role).toString().toStdString();
  if (const int kind = row->data(0, kind_role).toInt(); kind >= 0)
    place.kind = static_cast<item_kind>(kind);
  place.at = row->data(0, at_role).toULongLong();
  return place;
}

void loads_panel::show_menu(QPoint at) {
  auto* row = tree_->itemAt(at);
  if (!row)
    return;
  tree_->setCurrentItem(row);
  const auto place = current();
  if (!place)
    return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (place->kind) {
    menu->addAction(tr("Change ..."), this, [this, place] { edit_row(*place); });
    if (place->kind != item_kind::material)  // Two of one name for the same regions mean nothing.
      menu->addAction(tr("Duplicate"), this, [this, place] { duplicate(*place); });
    menu->addAction(tr("Remove"), this, [this, place] { drop(*place); });
  } else {
    menu->addAction(tr("Add a support"), this, [this] { add_item(item_kind::support); });
    menu->addAction(tr("Add a load"), this, [this] { add_item(item_kind::load); });
    menu->addAction(tr("Add a material"), this, [this] { add_item(item_kind::material); });
    menu->addSeparator();
    menu->addAction(tr("Duplicate"), this, [this, place] { duplicate(*place); });
    menu->addAction(tr("Rename ..."), this, [this, row] { tree_->editItem(row); });
    if (find(place->load_case, drafts_))
      menu->addAction(tr("Discard what is not solved yet"), this, [this, place] { drop(*place); });
    if (find(place->load_case, part_.loads().all()))
      menu->addAction(tr("Remove the load case"), this, [this, place] { remove_case(*place); });
  }
  menu->popup(tree_->viewport()->mapToGlobal(at));
}

// -- editing -------------------------------------------------------------------------

void loads_panel::new_load_case() {
  fem::load_case made;
  const auto cases = all();
  made.name = free_name(tr("Load case").toStdString(), cases);
  if (!cases.empty())
    made.materials = cases.front().materials;  // The part stays what it is made of.
  drafts_.push_back(made);
  refresh();
  tree_->setCurrentItem(tree_->topLevelItem(tree_->topLevelItemCount() - 1));
}

void loads_panel::add_item(item_kind kind) {
  if (!part_.head())
    return;
  auto cases = all();
  if (cases.empty())  // It is made when its first item is applied: a form that is left makes none.
    cases.emplace_back().name = tr("Load case").toStdString();
  const auto chosen = current();
  const auto* loads = chosen ? find(chosen->load_case, cases) : nullptr;
  if (!loads)
    loads = &cases.front();
  editing_ = row_place{loads->name, kind, count_of(*loads, kind)};
  unfinished_.open(*editor_, loads->name, kind, std::nullopt);
  const QString titles[] = {tr("New material"), tr("New support"), tr("New load")};
  open_editor(
    titles[static_cast<int>(kind)] + tr(" in %1").arg(QString::fromStdString(loads->name)),
    first_item(kind, picked_.surfaces()));
}

void loads_panel::edit_row(const row_place& place) {
  const auto cases = all();
  const auto* loads = find(place.load_case, cases);
  if (!loads || !place.kind || place.at >= count_of(*loads, *place.kind))
    return;
  editing_.reset();
  const auto item = item_at(*loads, *place.kind, place.at);
  unfinished_.open(*editor_, loads->name, *place.kind, item);
  if (const auto ids = surfaces_of(item); !ids.empty())  // Shift adds to what it has.
    picked_.set(ids);
  editing_ = place;
  open_editor(words(item), item);
}

void loads_panel::open_editor(const QString& title, const load_item& item) {
  editor_->set_selection(picked_.surfaces());
  editor_->edit(title, item);
  unfinished_.take_up(*editor_, picked_, part_);
  tree_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // The form comes first.
  editor_->show();
  show_parts();
  emit form_opened();
}

int loads_panel::wanted_height() const {
  const auto of = [this](const QWidget* one) {
    const int height = one->hasHeightForWidth() ? one->heightForWidth(width()) : -1;
    return one->isHidden() ? 0 : std::max(height, one->sizeHint().height());
  };
  return of(buttons_) + (tree_->isHidden() ? 0 : tree_->minimumSizeHint().height()) + of(hint_) +
         of(editor_);
}

void loads_panel::apply_editor() {
  const auto item = editor_->value();
  if (!item || !editing_)
    return;
  const auto cases = all();
  const auto* loads = find(editing_->load_case, cases);
  auto changed = loads ? *loads : fem::load_case{};
  changed.name = editing_->load_case;
  auto at = std::optional(editing_->at);
  const auto* material = std::get_if<fem::material>(&*item);
  if (material && *at >= changed.materials.size())
    at = place_for(changed, *material);
  put(changed, *item, at);
  cancel();
  if (!material)  // What was selected was meant, and its field is to be seen.
    picked_.clear();
  change(changed);
}

void loads_panel::close_editor() {
  unfinished_.leave(*editor_);
  editing_.reset();
  editor_->hide();
  tree_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  emit form_closed();
  show_parts();
}

/// An empty list would keep the hint away from its buttons; a form says itself what it lacks.
void loads_panel::show_parts() {
  const bool form = !editor_->isHidden();
  const bool any = tree_->topLevelItemCount() > 0;
  tree_->setVisible(any && (!form || window()->height() >= roomy_window));
  hint_->setVisible(!hint_->text().isEmpty() && (any || !form));
}

bool loads_panel::cancel() {
  const bool was_open = editing_.has_value();
  unfinished_.forget();
  close_editor();
  return was_open;
}

void loads_panel::duplicate(const row_place& place) {
  const auto cases = all();
  const auto* loads = find(place.load_case, cases);
  if (!loads)
    return;
  auto copy = *loads;
  if (place.kind)
    put(copy, item_at(*loads, *place.kind, place.at));
  else
    copy.name = free_name(loads->name + tr(" copy").toStdString(), cases);
  change(copy);
}

void loads_panel::drop(const row_place& place) {
  const auto cases = all();
  const auto* loads = find(place.load_case, cases);
  if (!loads)
    return;
  close_editor();
  if (!place.kind) {
    std::erase_if(drafts_, [&](const auto& one) { return one.name == place.load_case; });
    refresh();
    return;
  }
  auto changed = *loads;
  remove(changed, *place.kind, place.at);
  change(changed);
}

/// A draft of it goes with it.
void loads_panel::remove_case(const row_place& place) {
  close_editor();
  std::erase_if(drafts_, [&](const auto& one) { return one.name == place.load_case; });
  part_.loads().remove(place.load_case);
}

void loads_panel::remove_current() {
  const auto place = current();
  if (!place)
    return;
  if (!place->kind && find(place->load_case, part_.loads().all()))
    remove_case(*place);
  else
    drop(*place);
}

void loads_panel::renamed(QTreeWidgetItem* row) {
  if (filling_)
    return;
  const std::string before = row->data(0, case_role).toString().toStdString();
  const std::string name = row->text(0).trimmed().toStdString();
  const auto cases = all();
  const auto* loads = find(before, cases);
  if (!loads || name == before || name.empty() || find(name, cases)) {
    refresh();
    return;
  }
  auto copy = *loads;
  copy.name = name;
  const bool is_whole = missing(copy).isEmpty();
  const bool is_sent = find(before, part_.loads().all()) != nullptr;
  if (is_whole || !is_sent)
    std::erase_if(drafts_, [&](const auto& one) { return one.name == before; });
  if (!is_whole || !is_sent)
    return change(copy);
  put(drafts_, copy);
  part_.loads().rename(before, copy);
  refresh();
}

/// One that cannot be solved any more leaves the server: its stress would be that of other loads.
void loads_panel::change(const fem::load_case& loads) {
  put(drafts_, loads);
  if (missing(loads).isEmpty())
    part_.loads().set(loads);
  else if (find(loads.name, part_.loads().all()))
    part_.loads().remove(loads.name);
  refresh();
}

void loads_panel::take_up(const std::vector<fem::load_case>& kept) {
  for (const auto& one : kept)
    if (!find(one.name, drafts_))
      drafts_.push_back(one);
  if (!kept.empty())
    refresh();
}

void loads_panel::carry_drafts(const client::committed& what) {
  if (what.report && what.cause == "edit")
    for (auto& draft : drafts_)
      draft = carried(draft, what.report->surface_map);
  close_editor();  // Its surfaces may be gone.
  refresh();
}

}  // namespace tedit::desktop
