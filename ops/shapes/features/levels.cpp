// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/levels.hpp"

#include <algorithm>
#include <cstdio>

#include "mesh/place_text.hpp"
#include "ops/shapes/caps/caps.hpp"

namespace tedit::ops {

namespace {

/// A bent foot must lie on a quadric within this share of the protrusion's size.
constexpr double quadric_share = 0.01;

expected<level> curved_level(const mesh_version& mesh, const protrusion& feature,
                             const foot& stands_on, level result) {
  const auto own = facets_of(mesh, feature.surfaces);
  const auto around = surrounding_points(mesh, stands_on.facets, {own.begin(), own.end()});
  result.curved = fit_quadric(around);
  double off = 0;
  for (const auto& p : around)
    off = std::max(off, result.curved ? result.curved->distance(p) : feature.size);
  if (off > quadric_share * feature.size) {
    return fail(ec::not_a_protrusion,
                "what the selected surfaces stand on at " + place_text(result.point) +
                  " is neither flat nor evenly curved",
                "Select up to a clean edge");
  }
  // The gradient points out of the part where the facets do.
  if (result.curved->signed_distance(result.point + 1e-2 * feature.size * result.normal) <
      result.curved->signed_distance(result.point))
    result.curved->flip();
  result.tolerance = std::max(result.tolerance, 1.01 * off);
  return result;
}

}  // namespace

expected<std::vector<level>> levels_of(const mesh_version& mesh, const protrusion& feature) {
  std::vector<level> levels;
  for (const auto& stands_on : feature.feet) {
    level next;
    next.point = stands_on.point;
    next.normal = stands_on.normal;
    next.tolerance = 1e-7 * feature.size;
    const auto first = mesh.facet(stands_on.facets.front()).surface;
    if (std::ranges::all_of(stands_on.facets,
                            [&](facet_id f) { return mesh.facet(f).surface == first; }))
      next.surface = first;
    if (stands_on.flat) {
      next.tolerance = std::max(next.tolerance, 1.01 * stands_on.deviation);
    } else {
      auto curved = curved_level(mesh, feature, stands_on, next);
      if (!curved)
        return fail(curved.error());
      next = *curved;
    }
    levels.push_back(next);
  }
  return levels;
}

}  // namespace tedit::ops
