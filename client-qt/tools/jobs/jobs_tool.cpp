// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/jobs/jobs_tool.hpp"

#include <QMainWindow>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/jobs/jobs_panel.hpp"
#include "client-qt/tools/jobs/server_dialog.hpp"
#include "client-qt/widgets/show_one.hpp"

namespace tedit::desktop {

jobs_tool::jobs_tool(window_context& in) {
  auto* button = new jobs_button(in.part.work(), in.link);
  in.truth.add(button);
  in.all_commands.add({"view.jobs",
                       tr("What runs"),
                       command_groups::view(),
                       "J",
                       [button] { button->open_panel(); },
                       {},
                       tr("Jobs with their progress, and the server's workers")});
  in.all_commands.add({"view.server",
                       tr("Server and workers"),
                       command_groups::view(),
                       {},
                       [&in] {
                         show_one<server_dialog>(
                           in.window, [&in] { return new server_dialog(in.link, &in.window); });
                       },
                       {},
                       tr("What the server is, its memory, and the machines that work for it"),
                       "info"});
  in.esc.add(ends::wait, [&part = in.part] {
    const bool waits = part.foreground().current().has_value();
    if (waits)
      part.foreground().cancel();
    return waits;
  });
}

}  // namespace tedit::desktop
