// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results/results_tool.hpp"

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/carried_field.hpp"
#include "client-qt/model/field_values.hpp"
#include "client-qt/model/live_preview.hpp"
#include "client-qt/model/part_size.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/operations/preview_box.hpp"
#include "client-qt/tools/results/deformation_row.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/widgets/tall_scroll.hpp"

namespace tedit::desktop {

results_tool::results_tool(window_context& in, live_preview& preview)
    : in_(in), preview_(preview), panel_(new field_panel(in.part)) {
  in_.panels.add("field", tr("Field"), new tall_scroll(panel_));
  wire();
  add_commands();
}

void results_tool::wire() {
  connect(&in_.part, &document::surface_changed, this, &results_tool::show);
  connect(panel_, &field_panel::changed, this, &results_tool::show);
  connect(&panel_->deformation(), &deformation_row::swung, this, &results_tool::swing);
  connect(&in_.part, &document::begun, this, [this] { panel_->deformation().set_swinging(false); });
  connect(&preview_, &live_preview::changed, this, &results_tool::show);
  connect(&in_.view, &viewport::legend_changed, this, [this] {
    panel_->take_range(in_.view.painted().by, in_.view.painted().extremes.has_value());
  });
  connect(&in_.view, &viewport::shown, this, &results_tool::say_verdict);
  connect(&in_.part.solver(), &solve_requests::changed, this, &results_tool::say_verdict);
  connect(&in_.part.solver(), &solve_requests::changed, &in_.buttons, &command_actions::refresh);
}

void results_tool::add_commands() {
  const QString edit = command_groups::edit();
  const QString view = command_groups::view();
  const auto has_part = in_.has_part();
  in_.all_commands.add(
    {"edit.solve", tr("Solve again"), edit, "F5", [this] { in_.part.solver().solve(); }, has_part});
  in_.all_commands.add({"edit.cancel_solve",
                        tr("Stop the solver"),
                        edit,
                        {},
                        [this] { in_.part.solver().cancel(); },
                        [this] { return in_.part.solver().is_running(); },
                        {},
                        {},
                        tr("No solve of this part runs.")});
  in_.esc.add(ends::solve, [this] {
    in_.part.solver().cancel();
    return true;
  });
  in_.all_commands.add({"view.extremes", tr("Mark smallest and largest value"), view, "X",
                        [this] { in_.over.show_extremes(!in_.over.shows_extremes()); }, has_part});
  in_.all_commands.add({"view.isolines", tr("Show or hide isolines"), view, "N",
                        [this] { panel_->set_isolines(!panel_->isolines()); }, has_part,
                        tr("Lines of equal value on the surface and on a section")});
  in_.all_commands.add(
    {"view.animate",
     tr("Animate the deformation"),
     view,
     {},
     [this] { panel_->deformation().set_swinging(!panel_->deformation().swings()); },
     has_part,
     tr("Swings between the part without load and the deformed one")});
  for (const auto& group : field_groups())
    for (const auto field : group)
      in_.all_commands.add({"view.field_" + field_id(field),
                            tr("Show: %1").arg(field_title(field)),
                            view,
                            {},
                            [this, field] { panel_->set_field(field); },
                            has_part,
                            field_help(field)});
}

void results_tool::show() {
  const auto* head = in_.part.head();
  if (!head || !head->surface)
    return;
  in_.over.expect_legend(!head->info.load_cases.empty() || panel_->field());
  in_.part.solver().watch(needs(panel_->wanted().field));
  in_.truth.set_candidate(preview_.shown() != nullptr);
  const auto& refused = preview_.refusal();
  in_.view.mark(refused ? places_of(*refused) : std::vector<surface_id>{});
  in_.view.set_legend(panel_->wanted());
  in_.view.show_isolines(panel_->isolines() && !preview_.shown());
  if (const auto& shown = preview_.shown())
    return in_.view.show_part({shown->surface, field_of_preview(), 0, shown->before});
  carried_ = {};
  measure();
  in_.view.show_part({head->surface, panel_->field(), panel_->deformation().shown_factor()});
}

/// The stress as it is, where the edit leaves the part as it is: the legend's note says so.
shared_field results_tool::field_of_preview() {
  const auto field = panel_->field();
  const auto& shown = preview_.shown();
  if (!field || !shown->before || field->version_id() != shown->before->version_id())
    return nullptr;
  if (carried_.of != field || carried_.to != shown->surface)
    carried_ = {field, shown->surface, carried_field(*field, *shown->before, *shown->surface)};
  return carried_.result;
}

/// What an automatic deformation goes by: of the shown field and of the part.
void results_tool::measure() {
  const auto* head = in_.part.head();
  const auto field = panel_->field();
  if (!field || field->envelope || field == measured_)
    return;
  measured_ = field;
  panel_->deformation().take(field->report.max_displacement_m, size_of(*head->surface).diagonal());
}

/// A beat of an animation is left out while the one before it is not seen yet. Nothing else in the
/// window changes with it.
void results_tool::swing() {
  const auto* head = in_.part.head();
  if (head && head->surface && !preview_.shown() && in_.view.is_shape_seen())
    in_.view.show_part({head->surface, panel_->field(), panel_->deformation().shown_factor()});
}

void results_tool::say_verdict() {
  const QString verdict = in_.truth.verdict();
  const bool earlier = preview_.shown() && in_.view.current().field;
  QString note = earlier ? tr("stress before the edit that is previewed") : verdict;
  // A shape that nobody would believe must say that it is drawn larger, in pictures, too.
  if (in_.view.current().field && in_.view.current().deform != 0)
    note += "\n" + tr("deformation × %1").arg(number(panel_->deform()));
  in_.over.set_note(note);
}

}  // namespace tedit::desktop
