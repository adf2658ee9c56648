// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/loads_tool.hpp"

#include <QSettings>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/loads/load_glyphs.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"

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
                        in_.has_part(),
                        tr("What is chosen in \"Loads and supports\"")});
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

void loads_tool::show_glyphs(bool on) {
  glyphs_->show(on);
  in_.settings.setValue("show_loads", on);
}

}  // namespace tedit::desktop
