// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/help/help_tool.hpp"

#include <QDockWidget>
#include <QMainWindow>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/preferences.hpp"
#include "client-qt/tools/help/about_dialog.hpp"
#include "client-qt/tools/help/help_panel.hpp"
#include "client-qt/tools/help/shortcuts_dialog.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/widgets/show_one.hpp"

namespace tedit::desktop {

static constexpr int manual_width = 420;

help_tool::help_tool(window_context& in, const context_panel& operations)
    : in_(in), operations_(operations), panel_(new help_panel) {
  in_.panels.add("help", tr("Help"), panel_);
  connect(&in_.part, &document::operations_changed, this,
          [this] { panel_->set_operations(manual_page_of(in_.part.operations())); });
  add_dialogs();
  in_.all_commands.add({"help.manual",
                        tr("Help"),
                        command_groups::help(),
                        "F1",
                        [this] { open(); },
                        {},
                        tr("The manual: the page for what is being done, with a search"),
                        "info"});
}

void help_tool::add_dialogs() {
  in_.all_commands.add(
    {"help.shortcuts",
     tr("Keyboard shortcuts"),
     command_groups::help(),
     "Ctrl+F1",
     [this] {
       show_one<shortcuts_dialog>(in_.window, [this] {
         auto* made = new shortcuts_dialog({in_.all_commands, in_.settings}, &in_.window);
         connect(made, &shortcuts_dialog::changed, &in_.buttons, &command_actions::take_shortcuts);
         return made;
       });
     },
     {},
     tr("All commands with their keys, to look up and to change")});
  in_.all_commands.add({"help.about",
                        tr("About TEdit"),
                        command_groups::help(),
                        {},
                        [this] {
                          show_one<about_dialog>(in_.window,
                                                 [this] { return new about_dialog(&in_.window); });
                        },
                        {},
                        tr("Version, licence, libraries"),
                        "info"});
}

void help_tool::open() {
  auto& dock = in_.panels.of("help");
  const bool was_shown = dock.isVisible();
  dock.show();
  dock.raise();
  if (!was_shown)
    in_.window.resizeDocks({&dock}, {manual_width}, Qt::Horizontal);
  const auto [page, heading] = topic();
  panel_->show_page(page, heading);
  panel_->start_typing();
}

std::pair<QString, QString> help_tool::topic() const {
  if (const auto* chosen = in_.part.operations().find(operations_.chosen()))
    return {"operations", QString::fromStdString(chosen->about.name)};
  for (const auto* name : {"field", "receipt", "probes"})
    if (in_.panels.has_focus(name))
      return {"results", {}};
  if (in_.panels.has_focus("print"))
    return {"print", "Checks"};
  if (in_.panels.has_focus("results"))
    return {"desktop", "Results and report"};
  return {"desktop", "The flow"};  // How it is got is behind who reads it here.
}

}  // namespace tedit::desktop
