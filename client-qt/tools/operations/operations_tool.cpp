// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/operations_tool.hpp"

#include <QAction>

#include <algorithm>
#include <cstdlib>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/operations/drag_figures.hpp"
#include "client-qt/tools/operations/operation_handles.hpp"
#include "client-qt/widgets/operation_rail.hpp"

namespace tedit::desktop {

namespace {

/// A long name broken at the blank nearest to its middle: the rail takes its width from the view.
QString in_two_lines(QString name) {
  constexpr qsizetype long_name = 14;
  if (name.size() <= long_name)
    return name;
  qsizetype best = -1;
  for (auto at = name.indexOf(' '); at >= 0; at = name.indexOf(' ', at + 1))
    if (best < 0 || std::abs(2 * at - name.size()) < std::abs(2 * best - name.size()))
      best = at;
  if (best >= 0)
    name[best] = '\n';
  return name;
}

}  // namespace

operations_tool::operations_tool(window_context& in)
    : in_(in), panel_(new context_panel(in.part, in.picked)) {
  in_.panels.add("context", tr("Selection"), panel_);
  handles_ = new operation_handles(in_, *panel_);
  handles_->setParent(this);
  figures_ = new drag_figures(in_, *handles_, panel_->preview());
  connect(&in_.part, &document::operations_changed, this, &operations_tool::offer);
  connect(&in_.part, &document::begun, panel_, [this] {  // A form is for the part it was opened on.
    if (!panel_->chosen().isEmpty())
      panel_->choose({});
  });
  connect(panel_, &context_panel::place_wanted, &in_.view.framing(), &part_framing::fit);
  in_.takes_place = [this](const picked_point& at, Qt::KeyboardModifiers modifiers) {
    return handles_->take_place(at, modifiers & (Qt::ControlModifier | Qt::AltModifier));
  };
  add_commands();
}

void operations_tool::add_commands() {
  in_.all_commands.add({"edit.apply", tr("Apply the operation"), command_groups::edit(),
                        "Ctrl+Return", [this] { panel_->apply(); }, in_.has_part()});
  connect(
    &in_.part.edits().queue(), &edit_queue::abandoned, this, [this](const QStringList& changes) {
      in_.messages.add_to_error(tr("Waited behind it, so not made: %1").arg(changes.join(", ")));
    });
  in_.esc.add(ends::handle_drag, [this] { return handles_->cancel(); });
  in_.esc.add(ends::form, [this] {
    const bool open = !panel_->chosen().isEmpty();
    if (open)
      panel_->choose({});
    return open;
  });
}

/// From the catalogue: operations of plugins that this program never saw are there as well.
void operations_tool::offer() {
  const QString group = command_groups::operation();
  in_.buttons.forget_group(group);
  in_.all_commands.remove_group(group);
  in_.rail.clear();
  for (const auto& one : in_.part.operations().operations) {
    const auto id = QString::fromStdString(one.about.id);
    in_.all_commands.add({"op." + id,
                          QString::fromStdString(one.about.name),
                          group,
                          {},
                          [this, id] { panel_->choose(id); },
                          in_.has_part(),
                          QString::fromStdString(one.about.summary),
                          icon_of(one)});
    auto* button = in_.buttons.of("op." + id);
    button->setToolTip(QString::fromStdString(one.about.summary));
    button->setIconText(in_two_lines(QString::fromStdString(one.about.name)));
    in_.rail.add(button);
  }
  in_.buttons.refresh();
}

}  // namespace tedit::desktop
