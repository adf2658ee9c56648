// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/compare/compare_tool.hpp"

#include <QStackedWidget>

#include <algorithm>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/compare/compare_view.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/history/history_tool.hpp"
#include "client-qt/tools/results/field_panel.hpp"

namespace tedit::desktop {

compare_tool::compare_tool(window_context& in, const field_panel& fields, history_tool& history)
    : in_(in), fields_(fields), page_(new compare_view(in.part)) {
  in_.pages.addWidget(page_);
  wire(history);
  add_commands();
}

void compare_tool::wire(history_tool& history) {
  auto* drag = new version_drag(history.strip());
  connect(drag, &version_drag::dropped, this, &compare_tool::open);
  connect(drag, &version_drag::dropped, &in_.part, [this] { in_.part.refresh_history(); });
  connect(&history.strip(), &history_strip::comparison_wanted, this, [this](quint32 number) {
    const auto head = in_.part.head()->info.number;
    open(std::min(number, head), std::max(number, head));
    in_.part.refresh_history();
  });
  connect(page_, &compare_view::closed, this, &compare_tool::leave);
  connect(page_, &compare_view::version_wanted, this, [this, &history](quint32 version) {
    leave();
    history.step_to(version);
  });
  connect(&in_.look, &appearance::changed, page_, &compare_view::set_theme);
}

void compare_tool::add_commands() {
  const QString view = command_groups::view();
  in_.all_commands.add({"view.compare", tr("Compare with the version before"), view, "C",
                        [this] {
                          const auto* head = in_.part.head();
                          if (!leave())
                            open(*head->info.parent, head->info.number);
                        },
                        [this] { return in_.part.head() && in_.part.head()->info.parent; },
                        tr("Side by side with linked cameras, or their difference"), "compare"});
  in_.all_commands.add({"view.compare_difference",
                        tr("Comparison: difference or side by side"),
                        view,
                        {},
                        [this] { page_->show_difference(!page_->shows_difference()); },
                        [this] { return is_open(); }});
  in_.esc.add(ends::page, [this] { return leave(); });
}

bool compare_tool::is_open() const {
  return in_.pages.currentWidget() == page_;
}

void compare_tool::open(quint32 before, quint32 after) {
  const auto field = fields_.field();
  page_->open({before, after, fields_.wanted(),
               field && !field->envelope ? field->report.load_case : std::string(),
               fields_.deform(), in_.view.view().get(), in_.view.framing().free_aspect(),
               in_.view.framing().shows_whole()});
  in_.pages.setCurrentWidget(page_);
}

bool compare_tool::leave() {
  const bool was_open = is_open();
  if (was_open)
    in_.pages.setCurrentWidget(&in_.view);
  return was_open;
}

}  // namespace tedit::desktop
