// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/selection/selection_tool.hpp"

#include <QMainWindow>
#include <QMenu>
#include <QPushButton>
#include <QToolTip>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/field_values.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/selection/surface_finder.hpp"

namespace tedit::desktop {

selection_tool::selection_tool(window_context& in) : in_(in) {
  wire();
  add_hiding();
  add_box();
  add_finding();
  in_.esc.add(ends::selection, [this] {
    const bool any = !in_.picked.surfaces().empty();
    if (any)
      in_.picked.clear();
    return any;
  });
}

void selection_tool::wire() {
  connect(&in_.part, &document::begun, this, [this] { set_hidden({}); });
  connect(&in_.picked, &selection::changed, this,
          [this] { in_.view.select(in_.picked.surfaces()); });
  connect(&in_.view, &viewport::clicked, this, &selection_tool::click);
  connect(&in_.view, &viewport::boxed, this, &selection_tool::take_box);
  connect(&in_.view, &viewport::hovered, this, &selection_tool::show_tooltip);
  connect(&in_.view, &viewport::menu_wanted, this, &selection_tool::show_menu);
  connect(&in_.messages, &banner::place_wanted, this, &selection_tool::highlight);
}

void selection_tool::highlight(const QList<qint64>& surfaces) {
  const std::vector<surface_id> ids(surfaces.begin(), surfaces.end());
  in_.picked.set(ids);
  in_.view.framing().fit(ids);
}

void selection_tool::click(const std::optional<picked_point>& at, Qt::KeyboardModifiers modifiers) {
  if (!picks_)
    return;
  const auto* head = in_.part.head();  // A preview may have others.
  const bool adds = modifiers & Qt::ShiftModifier;
  const bool of_head =
    at && head && head->surface && head->surface->surfaces().contains(at->surface);
  if (of_head && !adds && in_.takes_place && in_.takes_place(*at, modifiers))
    return;
  if (of_head)
    in_.picked.click(at->surface, adds);
  else if (!at && !adds)
    in_.picked.clear();
}

// -- hiding --------------------------------------------------------------------------

void selection_tool::add_hiding() {
  const auto picked = [this] { return !in_.picked.surfaces().empty(); };
  const QString view = command_groups::view();
  in_.all_commands.add({"view.hide",
                        tr("Hide the selection"),
                        view,
                        "H",
                        [this] { hide_selection(); },
                        picked,
                        {},
                        "hide"});
  in_.all_commands.add({"view.isolate",
                        tr("Isolate the selection"),
                        view,
                        "I",
                        [this] { isolate_selection(); },
                        picked,
                        {},
                        "isolate"});
  in_.all_commands.add({"view.show_all", tr("Show everything"), view, "Shift+H",
                        [this] { set_hidden({}); }, [this] { return !hidden_.empty(); }});
  count_ = new QPushButton(&in_.view);
  count_->setObjectName("hidden_count");
  count_->setToolTip(tr("Show everything (Shift+H)"));
  count_->setFocusPolicy(Qt::NoFocus);  // Keys stay the view's.
  count_->hide();
  connect(count_, &QPushButton::clicked, this, [this] { set_hidden({}); });
}

void selection_tool::place_count(const QRect& cube) {
  constexpr int gap = 8;
  count_->adjustSize();
  count_->move(cube.x() - gap - count_->width(), cube.y());
}

void selection_tool::set_hidden(std::set<surface_id> surfaces) {
  hidden_ = std::move(surfaces);
  in_.view.hide(hidden_);
  in_.buttons.refresh();
  count_->setText(tr("Hidden surfaces: %1 - show all").arg(hidden_.size()));
  count_->setVisible(!hidden_.empty());
  emit hidden_changed();
}

void selection_tool::hide_selection() {
  auto all = hidden_;
  all.insert(in_.picked.surfaces().begin(), in_.picked.surfaces().end());
  set_hidden(std::move(all));
  in_.picked.clear();
}

void selection_tool::isolate_selection() {
  std::set<surface_id> others;
  if (const auto* head = in_.part.head(); head && head->surface)
    for (const auto& [id, row] : head->surface->surfaces())
      if (!in_.picked.contains(id))
        others.insert(id);
  set_hidden(std::move(others));
}

// -- boxes ---------------------------------------------------------------------------

void selection_tool::add_box() {
  in_.all_commands.add({"view.box", tr("Select with a box"), command_groups::edit(), "B",
                        [this] { set_boxing(!boxing_); }, in_.has_part(),
                        tr("Ctrl+drag in the view does the same")});
  in_.all_commands.add(
    {"edit.select_visible", tr("Select all that can be seen"), command_groups::edit(), "Ctrl+A",
     [this] { in_.view.pick_box_at(QRectF(in_.view.rect()), false, false); }, in_.has_part()});
  in_.esc.add(ends::drag_mode, [this] {
    const bool was_on = boxing_;
    set_boxing(false);
    return was_on;
  });
}

void selection_tool::set_boxing(bool on) {
  boxing_ = on;
  in_.view.set_boxing(on);
  if (on)
    in_.messages.show_news(
      tr("Draw a box. To the right: what lies in it altogether; to the left: all that it "
         "touches. Shift adds, Esc ends. Ctrl+drag does it at any time."));
}

void selection_tool::take_box(const std::vector<surface_id>& found, bool add) {
  auto all = found;
  if (add)
    all.insert(all.end(), in_.picked.surfaces().begin(), in_.picked.surfaces().end());
  in_.picked.set(all);
}

// -- words ---------------------------------------------------------------------------

void selection_tool::add_finding() {
  finder_ = new surface_finder(in_.part, in_.picked, &in_.window);
  connect(finder_, &surface_finder::found, this, &selection_tool::highlight);
  in_.all_commands.add({"edit.find_surfaces", tr("Find surfaces"), command_groups::edit(), "Ctrl+F",
                        [this] { finder_->open(); }, in_.has_part(),
                        tr("By a name, \"bores 8 to 12 mm\", equal ones, smooth neighbours")});
}

// -- at the pointer ------------------------------------------------------------------

void selection_tool::show_tooltip(const std::optional<picked_point>& at, QPoint global) {
  if (!at) {
    QToolTip::hideText();
    return;
  }
  QStringList lines{in_.part.surface_name(at->surface)};
  const auto* head = in_.part.head();
  if (head && head->surface) {
    const auto& rows = head->surface->surfaces();
    if (const auto row = rows.find(at->surface); row != rows.end())
      lines << tr("area %1").arg(quantity(row->second.area_m2, "m2"));
  }
  lines << in_.part.loads().acting_on({at->surface});
  const auto& by = in_.view.painted().by;
  if (const auto value = in_.view.value_at(*at))
    lines << field_title(by.field) + ": " + field_value(by.field, *value);
  QToolTip::showText(global + QPoint(16, 16), lines.join("\n"), &in_.view);
}

void selection_tool::show_menu(const std::optional<picked_point>& at, QPoint global) {
  if (at && !in_.picked.contains(at->surface))
    in_.picked.click(at->surface, false);
  auto* menu = new QMenu(&in_.window);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const auto& what : in_.all_commands.all())
    if (what.group == command_groups::operation())
      menu->addAction(in_.buttons.of(what.id));
  menu->addSeparator();
  for (const auto* id :
       {"view.hide", "view.isolate", "view.show_all", "view.fit", "file.mesh_anew"})
    menu->addAction(in_.buttons.of(id));
  menu->popup(global);
}

}  // namespace tedit::desktop
