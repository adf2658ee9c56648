// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/finish_edit.hpp"

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "base/stopwatch.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// By how much the volume grows from one version to a later one, from the facets that differ alone
/// (divergence theorem): apart from the tets, which the check sums up. Cost: O(facets).
double boundary_growth(const mesh_version& before, const mesh_version& after) {
  const auto same = [&](facet_id f) {
    if (f >= before.facet_slots() || f >= after.facet_slots() || !before.is_live_facet(f) ||
        !after.is_live_facet(f) || before.facet(f).v != after.facet(f).v)
      return false;
    return std::ranges::all_of(
      before.facet(f).v, [&](vertex_id v) { return before.position(v) == after.position(v); });
  };
  // Any origin will do; one nearby loses fewer digits.
  std::optional<vec3> origin;
  const auto under = [&](const mesh_version& mesh, facet_id f) {
    if (f >= mesh.facet_slots() || !mesh.is_live_facet(f))
      return 0.0;
    const auto& v = mesh.facet(f).v;
    if (!origin)
      origin = mesh.position(v[0]);
    return signed_volume(*origin, mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]));
  };
  double sum = 0;
  for (facet_id f = 0; f < std::max(before.facet_slots(), after.facet_slots()); ++f)
    if (!same(f)) {
      sum -= under(before, f);
      sum += under(after, f);
    }
  return sum;
}

/// The settings of one improvement. What an operation asks to be improved thoroughly is exactly
/// what it names; a local pass may take in the rings around.
improve_settings settings_of(const improve_request& wanted, const finish_settings& settings) {
  auto result = settings.improve;
  result.thorough.reset();
  if (wanted.how == improvement::thorough) {
    result.thorough = wanted.thorough;
    result.rings = 0;
  }
  return result;
}

}  // namespace

expected<finished_edit> finish_edit(const version_ptr& base, const version_ptr& candidate,
                                    const edit_claim& claim, const improve_request& wanted,
                                    const finish_settings& settings, const execution& run) {
  finished_edit result;
  result.version = candidate;
  std::unordered_set<tet_id> touched(claim.touched.begin(), claim.touched.end());
  stopwatch clock;
  result.volume_change = claim.volume_change;
  if (wanted.how != improvement::none) {
    if (auto valid = validate(wanted.thorough); !valid)
      return fail(valid.error());
    mesh_builder builder(candidate);
    auto report = improve(builder, claim.touched, settings_of(wanted, settings), run);
    if (!report)
      return fail(report.error());
    result.improvement = *report;
    for (const auto t : builder.touched())
      touched.insert(t);
    result.version = builder.freeze();
    if (wanted.how == improvement::thorough && wanted.thorough.tolerance.allows_any())
      result.volume_change += boundary_growth(*candidate, *result.version);
  }
  std::erase_if(touched, [&](tet_id t) {
    return t >= result.version->tet_slots() || !result.version->is_live_tet(t);
  });
  result.touched.assign(touched.begin(), touched.end());
  std::ranges::sort(result.touched);
  result.improve_ms = clock.restart();
  auto final_claim = claim;
  final_claim.touched = result.touched;
  final_claim.volume_change = result.volume_change;
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
