// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/section/section_tool.hpp"

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/section/section_bar.hpp"

namespace tedit::desktop {

section_tool::section_tool(window_context& in, const field_panel& fields)
    : in_(in), bar_(new section_bar(in.part, in.view, fields)) {
  connect(&in_.view, &viewport::clicked, this,
          [this](const std::optional<picked_point>& at) { last_click_ = at; });
  const QString view = command_groups::view();
  in_.all_commands.add({"view.section", tr("Section plane"), view, "S",
                        [this] { bar_->set_on(!bar_->is_on()); }, in_.has_part(),
                        tr("Cuts the part and shows the field inside"), "section"});
  in_.all_commands.add({"view.section_at", tr("Section parallel to the last click"), view,
                        "Shift+S",
                        [this] {
                          if (last_click_)
                            bar_->set_plane(last_click_->at, last_click_->normal);
                        },
                        [this] { return in_.part.head() && last_click_; }});
}

}  // namespace tedit::desktop
