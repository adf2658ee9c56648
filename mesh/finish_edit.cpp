// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/finish_edit.hpp"

#include <algorithm>
#include <unordered_set>

#include "base/stopwatch.hpp"
#include "mesh/quality.hpp"

namespace tedit {

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
  final_claim.quality_floor =
    std::min(settings.quality_floor, std::max(claim.quality_floor, lowest_quality_floor));
  const auto report = check_edit(*base, *result.version, final_claim);
  if (!report.ok())
    return fail(to_error(report));
  result.touched_min_before = worst_quality_before(*base, *result.version, result.touched);
  const auto quality = radius_ratios(*result.version, result.touched);
  result.touched_min_after = quality.min;
  result.touched_median_after = quality.median;
  result.check_ms = clock.restart();
  return result;
}

}  // namespace tedit
