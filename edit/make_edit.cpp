// SPDX-License-Identifier: AGPL-3.0-or-later
#include "edit/make_edit.hpp"

#include "base/stopwatch.hpp"
#include "mesh/changes.hpp"
#include "ops/loader/operation_log.hpp"

namespace tedit {

namespace {

/// Only pages that differ are looked at, so the cost follows the edit.
void count_tets(const mesh_version& base, const mesh_version& after, edit_report& report) {
  for_each_dirty_slot(base.data().tets, after.data().tets, [&](tet_id t) {
    const bool was = t < base.tet_slots() && base.is_live_tet(t);
    const bool is = t < after.tet_slots() && after.is_live_tet(t);
    const bool same = was && is && base.tet_at(t) == after.tet_at(t);
    report.tets_removed += was && !same;
    report.tets_added += is && !same;
  });
}

/// What the operation and the request say; the rest is found out.
edit_report begin_report(const edit_candidate& candidate, const edit_request& wanted) {
  edit_report report;
  report.operation = wanted.operation;
  report.surfaces = wanted.surfaces;
  report.loads = wanted.loads;
  report.surfaces_used = candidate.made.surfaces_used;
  report.notices = candidate.made.notices;
  report.figures = candidate.made.figures;
  report.operation_ms = candidate.operation_ms;
  return report;
}

/// Loads and supports on the surfaces that there are then. Errors: those of `fem::refuse_losses`
/// where none may be lost.
expected<void> carry_loads(const mesh_version& base, const std::vector<fem::load_case>& load_cases,
                           const edit_request& wanted, checked_edit& result) {
  auto& report = result.report;
  report.from_version = to_hex(base.id());
  report.to_version = to_hex(result.version->id());
  report.surface_map = compare_surfaces(base, *result.version);
  for (const auto& loads : load_cases) {
    auto carried = fem::carry_over(loads, base, *result.version, report.surface_map, wanted.loads);
    report.receipt.insert(report.receipt.end(), carried.lines.begin(), carried.lines.end());
    result.load_cases.push_back(std::move(carried.after));
  }
  if (wanted.loads.policy == fem::load_policy::refuse)
    return fem::refuse_losses(report.receipt);
  return {};
}

}  // namespace

expected<edit_candidate> run_operation(const ops::catalogue& plugins, const version_ptr& base,
                                       const edit_request& wanted, const operation_place& place,
                                       const execution& run) {
  const stopwatch clock;
  ops::context ctx;
  ctx.host = place.host.get();
  ctx.run = run;
  ctx.search_s = place.find_most ? ops::refusal_search_s : 0;
  if (place.log)
    ctx.log = ops::operation_log(wanted.operation, place.log);
  auto limits = place.child.value_or(ops::operation_limits());
  if (limits.programs.empty())
    limits.programs = ops::programs_of_operations();
  auto made = place.child
                ? ops::run_operation_in_child(plugins, wanted.operation, base, {wanted.surfaces},
                                              wanted.parameters, ctx, limits)
                : ops::run_operation(plugins, wanted.operation, base, {wanted.surfaces},
                                     wanted.parameters, ctx);
  if (!made)
    return fail(made.error());
  return edit_candidate{std::move(*made), clock.milliseconds()};
}

expected<checked_edit> check_candidate(const version_ptr& base, const edit_candidate& candidate,
                                       const edit_request& wanted,
                                       const std::vector<fem::load_case>& load_cases,
                                       const execution& run) {
  run.report(0, "improving and checking");
  const auto& made = candidate.made;
  const edit_claim claim{made.volume_change, made.touched, made.quality_floor, made.bodies_added};
  const auto finished =
    finish_edit(base, made.candidate, claim, {made.improve, made.thorough}, {}, run);
  if (!finished)
    return fail(finished.error());
  checked_edit result{finished->version, {}, begin_report(candidate, wanted)};
  auto& report = result.report;
  if (auto carried = carry_loads(*base, load_cases, wanted, result); !carried)
    return fail(std::move(carried.error()));
  count_tets(*base, *result.version, report);
  report.volume_change = finished->volume_change;
  if (finished->improvement.before)
    report.optimisation = finished->improvement;
  report.ratios = finished->ratios;
  report.improve_ms = finished->improve_ms;
  report.check_ms = finished->check_ms;
  return result;
}

expected<checked_edit> draft_of(const version_ptr& base, const edit_candidate& candidate,
                                const edit_request& wanted,
                                const std::vector<fem::load_case>& load_cases) {
  checked_edit result{candidate.made.candidate, {}, begin_report(candidate, wanted)};
  if (auto carried = carry_loads(*base, load_cases, wanted, result); !carried)
    return fail(std::move(carried.error()));
  result.report.volume_change = candidate.made.volume_change;
  // Measured on a result that is none, and said of ids that may be each other's.
  result.report.figures.clear();
  result.report.notices.clear();
  return result;
}

expected<checked_edit> make_edit(const ops::catalogue& plugins, const version_ptr& base,
                                 const edit_request& wanted,
                                 const std::vector<fem::load_case>& load_cases,
                                 const operation_place& place, const execution& run) {
  const stopwatch total;
  const auto candidate = run_operation(plugins, base, wanted, place, run.part(0, 0.8));
  if (!candidate)
    return fail(candidate.error());
  auto done = check_candidate(base, *candidate, wanted, load_cases, run.part(0.85, 1));
  if (done)
    done->report.total_ms = total.milliseconds();
  return done;
}

}  // namespace tedit
