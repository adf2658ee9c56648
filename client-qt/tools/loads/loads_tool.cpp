// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/loads_tool.hpp"

#include <QSettings>

#include <utility>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/loads/load_glyphs.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

loads_tool::loads_tool(window_context& in, field_panel& fields, selection_tool& selecting)
    : in_(in),
      panel_(new loads_panel(in.part, in.picked)),
      glyphs_(new load_glyph_layer(in.part, fields, in.view)) {
  in_.panels.add("loads", tr("Loads and supports"), panel_);
  glyphs_->show(in_.settings.value("show_loads", true).toBool());
  connect(panel_, &loads_panel::surfaces_wanted, &selecting, &selection_tool::highlight);
  connect(panel_, &loads_panel::drafts_changed, glyphs_,
          [this] { glyphs_->set_drafts(panel_->drafts()); });
  connect(panel_, &loads_panel::drafts_changed, this, &loads_tool::keep_drafts);
  connect(panel_, &loads_panel::chosen_changed, &in_.buttons, &command_actions::refresh);
  connect(&in_.part, &document::begun, this, [this] { looks_for_drafts_ = in_.part.is_open(); });
  connect(&in_.part, &document::opened, this, &loads_tool::find_drafts);
  connect(&in_.part, &document::opened, this, [this] {
    if (const auto* head = in_.part.head(); head && head->info.load_cases.empty())
      in_.panels.raise("loads");  // What comes next stands there.
  });
  in_.esc.add(ends::load_form, [this] { return panel_->cancel(); });
  add_commands();
}

void loads_tool::add_commands() {
  in_.all_commands.add({"view.loads", tr("Show or hide loads and supports"), command_groups::view(),
                        "L", [this] { show_glyphs(!glyphs_->is_shown()); }, in_.has_part(),
                        tr("Arrows and support marks of the load case that is shown"), "load"});
  add_item("loads.add_support", tr("Add a support"), "support", item_kind::support);
  add_item("loads.add_load", tr("Add a load"), "load", item_kind::load);
  add_item("loads.add_material", tr("Add a material"), "material", item_kind::material);
  in_.all_commands.add({"loads.new_case",
                        tr("New load case"),
                        command_groups::loads(),
                        {},
                        [this] { panel_->new_load_case(); },
                        in_.has_part()});
  in_.all_commands.add({"loads.remove",
                        tr("Remove the chosen load, support or load case"),
                        command_groups::loads(),
                        {},
                        [this] { panel_->remove_current(); },
                        [this] { return in_.part.head() && panel_->can_remove(); },
                        tr("What is chosen in \"Loads and supports\""),
                        {},
                        tr("Choose one in \"Loads and supports\" first.")});
}

void loads_tool::add_item(const char* id, const QString& title, const char* drawing,
                          item_kind kind) {
  in_.all_commands.add({id,
                        title,
                        command_groups::loads(),
                        {},
                        [this, kind] {
                          in_.panels.raise("loads");
                          panel_->add_item(kind);
                        },
                        in_.has_part(),
                        {},
                        drawing});
}

/// With the document's name, among the settings: nobody else can do anything with what is not
/// complete yet.
void loads_tool::keep_drafts() {
  if (looks_for_drafts_ || !in_.part.head())
    return;  // They go with their document, or come with it.
  QStringList all;
  for (const auto& one : panel_->drafts())
    if (!missing(one).isEmpty())
      all << QString::fromStdString(protocol::load_case_to_json(one));
  const QString key = drafts_key(in_.part.name());
  if (all.isEmpty())
    in_.settings.remove(key);
  else if (in_.settings.value(key).toStringList() != all)
    in_.settings.setValue(key, all);
}

void loads_tool::find_drafts() {
  if (!std::exchange(looks_for_drafts_, false))
    return;
  std::vector<fem::load_case> kept;
  for (const auto& text : in_.settings.value(drafts_key(in_.part.name())).toStringList())
    if (const auto read = protocol::load_case_from_json(text.toStdString(), "the settings"))
      kept.push_back(*read);
  panel_->take_up(kept);
}

void loads_tool::show_glyphs(bool on) {
  glyphs_->show(on);
  in_.settings.setValue("show_loads", on);
}

}  // namespace tedit::desktop
