// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/settings/settings_tool.hpp"

#include <QMainWindow>
#include <QSettings>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/settings/settings_dialog.hpp"
#include "client-qt/widgets/show_one.hpp"

namespace tedit::desktop {

settings_tool::settings_tool(window_context& in, field_panel& fields)
    : in_(in),
      fields_(fields),
      system_dark_(in.window.palette().color(QPalette::Window).lightness() < 128) {
  in_.all_commands.add({"file.settings",
                        tr("Settings"),
                        command_groups::file(),
                        "Ctrl+,",
                        [this] { open(); },
                        {},
                        tr("Colours, solver, legend, log"),
                        "settings"});
}

void settings_tool::apply_kept() {
  apply(load_preferences(in_.settings));
}

void settings_tool::apply(const preferences& wanted) {
  in_.look.set_dark(wanted.look == look_wish::dark ||
                    (wanted.look == look_wish::system && system_dark_));
  const auto turning =
    wanted.turning == turning_wish::orbit ? camera::turning::orbit : camera::turning::turntable;
  for (auto* view : in_.window.findChildren<viewport*>())
    view->view().set_turning(turning);
  save(wanted, in_.settings);
  fields_.set_look(wanted.map, wanted.locked, wanted.logarithmic);
  in_.log.set_level(wanted.log);
  if (const auto solve = solve_settings_of(wanted); solve != in_.part.solver().settings())
    in_.part.solver().set_settings(solve);
}

void settings_tool::open() {
  show_one<settings_dialog>(in_.window, [this] {
    auto* made = new settings_dialog(load_preferences(in_.settings), &in_.window);
    connect(made, &settings_dialog::changed, this, &settings_tool::apply);
    return made;
  });
}

}  // namespace tedit::desktop
