// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/finish_edit.hpp"

#include <algorithm>
#include <unordered_set>

#include "base/stopwatch.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Worst q among the base's tets that share a vertex with the touched region.
double worst_before(const mesh_version& base, const mesh_version& after,
                    const std::vector<tet_id>& touched) {
  std::unordered_set<vertex_id> corners;
  for (const auto t : touched)
    corners.insert(after.tet_at(t).v.begin(), after.tet_at(t).v.end());
  double worst = 1;
  for (tet_id t = 0; t < base.tet_slots(); ++t)
    if (base.is_live_tet(t) &&
        std::ranges::any_of(base.tet_at(t).v, [&](vertex_id v) { return corners.contains(v); }))
      worst = std::min(worst, radius_ratio(base.corners(t)));
  return worst;
}

}  // namespace

expected<finished_edit> finish_edit(const version_ptr& base, const version_ptr& candidate,
                                    const edit_claim& claim, bool improve_region,
                                    const finish_settings& settings, const execution& run) {
  finished_edit result;
  result.version = candidate;
  std::unordered_set<tet_id> touched(claim.touched.begin(), claim.touched.end());
  stopwatch clock;
  if (improve_region) {
    mesh_builder builder(candidate);
    auto report = improve(builder, claim.touched, settings.improve, run);
    if (!report)
      return fail(report.error());
    result.improvement = *report;
    for (const auto t : builder.touched())
      touched.insert(t);
    result.version = builder.freeze();
  }
  std::erase_if(touched, [&](tet_id t) {
    return t >= result.version->tet_slots() || !result.version->is_live_tet(t);
  });
  result.touched.assign(touched.begin(), touched.end());
  std::ranges::sort(result.touched);
  result.improve_ms = clock.restart();
  auto final_claim = claim;
  final_claim.touched = result.touched;
  final_claim.quality_floor = settings.quality_floor;
  const auto report = check_edit(*base, *result.version, final_claim);
  if (!report.ok())
    return fail(to_error(report));
  result.touched_min_before = worst_before(*base, *result.version, result.touched);
  const auto quality = radius_ratios(*result.version, result.touched);
  result.touched_min_after = quality.min;
  result.touched_median_after = quality.median;
  result.check_ms = clock.restart();
  return result;
}

}  // namespace tedit
