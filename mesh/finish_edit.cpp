// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/finish_edit.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_set>

#include "base/stopwatch.hpp"
#include "mesh/adapt/settle_on_walls.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/place_text.hpp"
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

/// What q no tet on a triangle can exceed: 1.5 times the triangle's own ratio 2 r_in / R_circ. For
/// the section of the tet's inscribed ball at the height of its centre is seen from the apex as a
/// larger disc inside the triangle, and the circumscribed ball holds the triangle's circle; thin
/// triangles reach the bound.
double best_ratio_on(vec3 a, vec3 b, vec3 c) {
  const double x = norm(c - b);
  const double y = norm(a - c);
  const double z = norm(b - a);
  const double area = norm(area_vector(a, b, c));
  const double product = x * y * z * (x + y + z);
  return product > 0 ? 1.5 * 16 * area * area / product : 0;
}

/// The region with the rings that a local pass may change.
std::vector<tet_id> with_rings(const mesh_version& mesh, std::vector<tet_id> region, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    std::unordered_set<vertex_id> corners;
    for (const auto t : region)
      corners.insert(mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
    region = tets_around(mesh, std::vector(corners.begin(), corners.end()));
  }
  return region;
}

/// A local pass moves no boundary vertex: where a facet is too thin for any tet on it to be good
/// enough, it need not begin. Errors: `postcondition_failed` naming surface and place.
/// Cost: O(touched).
expected<void> check_facets_are_wide(const mesh_version& base, const mesh_version& candidate,
                                     const std::vector<tet_id>& touched, double floor, int rings) {
  double worst = floor;
  facet_id thinnest = no_id;
  std::vector<tet_id> live;
  for (const auto t : touched) {
    if (t >= candidate.tet_slots() || !candidate.is_live_tet(t))
      continue;
    live.push_back(t);
    for (const auto behind : candidate.neighbours(t)) {
      if (!is_facet(behind))
        continue;
      const auto& v = candidate.facet(behind & ~facet_flag).v;
      const double best =
        best_ratio_on(candidate.position(v[0]), candidate.position(v[1]), candidate.position(v[2]));
      if (best < worst)
        std::tie(worst, thinnest) = std::tuple(best, behind & ~facet_flag);
    }
  }
  if (thinnest == no_id)
    return {};
  const double before =
    worst_quality_before(base, candidate, with_rings(candidate, std::move(live), rings));
  if (worst >= std::min(floor, before) * (1 - 1e-9))
    return {};
  const auto& facet = candidate.facet(thinnest);
  const vec3 p = (candidate.position(facet.v[0]) + candidate.position(facet.v[1]) +
                  candidate.position(facet.v[2])) /
                 3;
  char text[96];
  std::snprintf(text, sizeof(text),
                "that is too thin: no tet on it has more than q = %.3g (floor %.3g)", worst,
                std::min(floor, before));
  return fail(ec::postcondition_failed,
              "the edit was rolled back: surface " + std::to_string(facet.surface) +
                " would get a facet at " + place_text(p) + " " + text,
              "The version is unchanged; try other surfaces or parameters");
}

/// Ascending.
std::vector<tet_id> live_in(const mesh_version& mesh, const std::unordered_set<tet_id>& tets) {
  std::vector<tet_id> live;
  for (const auto t : tets)
    if (t < mesh.tet_slots() && mesh.is_live_tet(t))
      live.push_back(t);
  std::ranges::sort(live);
  return live;
}

/// A candidate on its way, and the tets that are new or changed so far.
struct edit_in_work {
  version_ptr version;
  std::vector<tet_id> touched;
  double volume_change = 0;  ///< m^3
  bool is_settled = false;   ///< Vertices have gone onto their walls.
};

/// It goes on with a version in which these tets are new or changed as well.
void go_on(edit_in_work& edit, version_ptr version, const std::vector<tet_id>& more) {
  edit.version = std::move(version);
  std::unordered_set<tet_id> touched(edit.touched.begin(), edit.touched.end());
  touched.insert(more.begin(), more.end());
  edit.touched = live_in(*edit.version, touched);
}

expected<void> settle(const mesh_version& base, double floor, const execution& run,
                      edit_in_work& edit, settling_vertices which) {
  const auto settled = settle_on_walls(base, edit.version, floor, run, which);
  if (!settled)
    return fail(settled.error());
  if (!*settled)
    return {};
  edit.is_settled = true;
  edit.volume_change += boundary_growth(*edit.version, *(*settled)->version);
  go_on(edit, (*settled)->version, (*settled)->touched);
  return {};
}

expected<improve_report> improve_as_wanted(const improve_request& wanted,
                                           const finish_settings& settings, double floor,
                                           const execution& run, edit_in_work& edit) {
  if (auto valid = validate(wanted.thorough); !valid)
    return fail(valid.error());
  const auto before = edit.version;
  mesh_builder builder(before);
  auto report = improve(builder, edit.touched, settings_of(wanted, settings), run);
  if (!report)
    return fail(report.error());
  go_on(edit, builder.freeze(), builder.touched());
  if (wanted.how != improvement::thorough || !wanted.thorough.tolerance.allows_any())
    return report;
  edit.volume_change += boundary_growth(*before, *edit.version);
  if (settings.settle)
    if (auto ok = settle(*before, floor, run, edit, settling_vertices::moved); !ok)
      return fail(ok.error());
  return report;
}

}  // namespace

expected<finished_edit> finish_edit(const version_ptr& base, const version_ptr& candidate,
                                    const edit_claim& claim, const improve_request& wanted,
                                    const finish_settings& settings, const execution& run) {
  finished_edit result;
  stopwatch clock;
  edit_in_work edit{candidate, claim.touched, claim.volume_change};
  const double floor =
    std::min(settings.quality_floor, std::max(claim.quality_floor, lowest_quality_floor));
  if (settings.settle)
    if (auto ok = settle(*base, floor, run, edit, settling_vertices::fresh); !ok)
      return fail(ok.error());
  if (wanted.how == improvement::local)
    if (auto wide =
          check_facets_are_wide(*base, *candidate, claim.touched, floor, settings.improve.rings);
        !wide)
      return fail(wide.error());
  if (wanted.how != improvement::none) {
    const auto improved = improve_as_wanted(wanted, settings, floor, run, edit);
    if (!improved)
      return fail(improved.error());
    result.improvement = *improved;
  }
  result.version = edit.version;
  result.touched = live_in(*edit.version, {edit.touched.begin(), edit.touched.end()});
  result.volume_change = edit.volume_change;
  result.improve_ms = clock.restart();
  auto final_claim = claim;
  final_claim.touched = result.touched;
  final_claim.volume_change = result.volume_change;
  final_claim.quality_floor = floor;
  const auto report = check_edit(*base, *result.version, final_claim);
  if (!report.ok() && edit.is_settled) {  // What does not hold so may hold as it was made.
    auto as_made = settings;
    as_made.settle = false;
    return finish_edit(base, candidate, claim, wanted, as_made, run);
  }
  if (!report.ok())
    return fail(to_error(report));
  if (!result.touched.empty()) {
    const auto after = radius_ratios(*result.version, result.touched);
    result.ratios = {worst_quality_before(*base, *result.version, result.touched), after.min,
                     after.median};
  }
  result.check_ms = clock.restart();
  return result;
}

}  // namespace tedit
