// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/history/history_tool.hpp"

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/cad_words.hpp"
#include "client-qt/tools/history/history_strip.hpp"

namespace tedit::desktop {

history_tool::history_tool(window_context& in) : in_(in), strip_(new history_strip(in.part)) {
  in_.panels.add("history", tr("History"), strip_);
  connect(strip_, &history_strip::version_wanted, this, &history_tool::step_to);
  connect(&in_.look, &appearance::changed, strip_, &history_strip::set_theme);
  connect(&in_.part, &document::cad_known, this, &history_tool::tell_cad);
  add_commands();
}

/// Only what a person may want to take back: the marks in the history say the rest.
void history_tool::tell_cad(const client::version_info& version) {
  const auto& all = in_.part.versions();
  const auto parent = version.parent ? all.find(*version.parent) : all.end();
  const QString news =
    cad_news(version, parent == all.end() ? std::nullopt : parent->second.info.cad);
  if (news.isEmpty())
    return;
  in_.log.write(news);
  in_.messages.show_warning(news);
}

void history_tool::add_commands() {
  const QString edit = command_groups::edit();
  in_.all_commands.add(
    {"edit.undo", tr("Undo"), edit, "Ctrl+Z", [this] { undo(); },
     [this] { return is_busy() || in_.part.edits().can_undo() || in_.part.loads().can_undo(); },
     tr("The last edit, or the last change of loads"), "undo"});
  in_.all_commands.add(
    {"edit.redo", tr("Redo"), edit, "Ctrl+Y", [this] { redo(); },
     [this] { return is_busy() || in_.part.edits().can_redo() || in_.part.loads().can_redo(); },
     tr("What was undone last"), "redo"});
  in_.all_commands.add({"history.words", tr("Name and note of a version"), edit, "Ctrl+F2",
                        [this] {
                          in_.panels.raise("history");
                          strip_->edit_words();
                        },
                        in_.has_part(), tr("Of the one that is chosen in the history")});
}

bool history_tool::is_busy() const {
  return in_.part.head() && in_.part.foreground().current();
}

/// Changes of loads come after the edit that made their version. Behind a change that runs it is
/// that one that is taken back.
void history_tool::undo() {
  in_.part.edits().queue().add(tr("Undo"), [&part = in_.part] {
    if (part.loads().can_undo())
      part.loads().undo();
    else if (part.edits().can_undo())
      part.edits().undo();
  });
}

void history_tool::redo() {
  in_.part.edits().queue().add(tr("Redo"), [&part = in_.part] {
    if (part.loads().can_redo())
      part.loads().redo();
    else if (part.edits().can_redo())
      part.edits().redo();
  });
}

void history_tool::step_to(std::uint32_t version) {
  in_.part.edits().queue().add(tr("Go to version %1").arg(version), [version, &part = in_.part] {
    const auto* head = part.head();
    if (head && head->info.number != version)
      part.edits().go_to(version);
  });
}

}  // namespace tedit::desktop
