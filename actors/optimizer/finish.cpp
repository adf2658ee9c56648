// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/optimizer/finish.hpp"

namespace tedit::actors {

namespace {

/// Only pages that differ are looked at, so the cost follows the edit.
void count_tets(const mesh_version& base, const mesh_version& after, edit_report& report) {
  constexpr std::size_t tets_row = 2;  // Of `manifest::arrays`.
  const std::size_t per_page = paged_array<tet>::items_per_page;
  for (const auto p :
       dirty_pages(base.pages().arrays.at(tets_row), after.pages().arrays.at(tets_row))) {
    const auto last = std::max(base.tet_slots(), after.tet_slots());
    for (std::size_t slot = p * per_page; slot < std::min<std::size_t>((p + 1) * per_page, last);
         ++slot) {
      const auto t = static_cast<tet_id>(slot);
      const bool was = t < base.tet_slots() && base.is_live_tet(t);
      const bool is = t < after.tet_slots() && after.is_live_tet(t);
      const bool same = was && is && base.tet_at(t) == after.tet_at(t);
      report.tets_removed += was && !same;
      report.tets_added += is && !same;
    }
  }
}

}  // namespace

expected<finished_candidate> finish_candidate(const version_ptr& base, const version_ptr& candidate,
                                              const edit_claim& claim,
                                              const improve_request& wanted,
                                              const std::vector<fem::load_case>& load_cases,
                                              const fem::carry_settings& settings,
                                              const execution& run) {
  run.report(0, "improving and checking");
  const auto finished = finish_edit(base, candidate, claim, wanted, {}, run);
  if (!finished)
    return fail(finished.error());
  finished_candidate result;
  result.version = finished->version;
  auto& report = result.report;
  report.from_version = to_hex(base->id());
  report.to_version = to_hex(result.version->id());
  report.surface_map = compare_surfaces(*base, *result.version);
  for (const auto& loads : load_cases) {
    auto carried = fem::carry_over(loads, *base, *result.version, report.surface_map, settings);
    report.receipt.insert(report.receipt.end(), carried.lines.begin(), carried.lines.end());
    result.load_cases.push_back(std::move(carried.after));
  }
  report.loads = settings;
  if (settings.policy == fem::load_policy::refuse)
    if (auto nothing_lost = fem::refuse_losses(report.receipt); !nothing_lost)
      return fail(std::move(nothing_lost.error()));
  count_tets(*base, *result.version, report);
  report.volume_change = finished->volume_change;
  if (finished->improvement.before)
    report.optimisation = finished->improvement;
  report.ratios = finished->ratios;
  report.improve_ms = finished->improve_ms;
  report.check_ms = finished->check_ms;
  return result;
}

}  // namespace tedit::actors
