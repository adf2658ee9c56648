// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/wall_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mesh/place_text.hpp"
#include "ops/shapes/walls/near_boundary.hpp"

namespace tedit::ops {

namespace {

/// A facet whose normal has less than this along a wall's faces that wall.
constexpr double facing = -0.5;

/// What faces a wall.
struct narrow_place {
  double space = 1e300;  ///< m.
  vec3 at;
  surface_id wall = 0;
  surface_id other = 0;
};

std::array<vec3, 3> corners_of(const mesh_version& mesh, facet_id f) {
  const auto& v = mesh.facet(f).v;
  return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

/// The least space that is not enough.
narrow_place narrowest(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                       double distance) {
  const auto facets = facets_of(mesh, surfaces);
  const double depth = std::abs(distance);
  box around;
  for (const auto f : facets)
    for (const auto& p : corners_of(mesh, f))
      around.add(p);
  const near_boundary boundary(mesh, around.grown(2 * depth));
  narrow_place least;
  for (const auto f : facets) {
    const auto p = corners_of(mesh, f);
    const vec3 normal = normalized(area_vector(p[0], p[1], p[2]));
    const vec3 way = distance < 0 ? -normal : normal;
    const vec3 from = (p[0] + p[1] + p[2]) / 3 + 1e-6 * norm(p[1] - p[0]) * way;
    for (const auto& hit : boundary.along(from, way, 2 * depth)) {
      const auto other = mesh.facet(hit.facet).surface;
      const double needed = std::ranges::count(surfaces, other) ? 2 * depth : depth;
      const vec3 faced = normalized(area_vector(mesh, mesh.facet(hit.facet)));
      // A bore that narrows onto itself is told by its radius.
      if (other == mesh.facet(f).surface || dot(faced, normal) > facing || hit.distance > needed ||
          hit.distance >= least.space)
        continue;
      least = {hit.distance, from, mesh.facet(f).surface, other};
    }
  }
  return least;
}

}  // namespace

expected<void> check_space(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                           double distance) {
  const auto least = narrowest(mesh, surfaces, distance);
  if (least.space > 2 * std::abs(distance))
    return {};
  char size[32];
  std::snprintf(size, sizeof(size), "%.4g mm", 1e3 * least.space);
  return fail(ec::invalid_argument,
              (distance < 0 ? "the part is only " + std::string(size) + " thick"
                            : "there are only " + std::string(size) + " of space") +
                " between surfaces " + std::to_string(least.wall) + " and " +
                std::to_string(least.other) + " at " + place_text(least.at));
}

}  // namespace tedit::ops
