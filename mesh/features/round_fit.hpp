// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/features/wall_shape.hpp"

namespace tedit {

/// Brings a cylinder or cone that is near some points nearest to them: Gauss-Newton on the sum of
/// (distance from the axis - radius there)^2 over the axis' point and direction, the radius and,
/// for a cone, the slope. `size`: of the points' extent, for the scale of angles. Cost: O(points).
void refine_round_wall(std::span<const vec3> points, double size, wall_shape& shape);

/// Facets as triangles over their corners, which stand in the order of the mesh.
struct facet_corners {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
[[nodiscard]] facet_corners corners_of(const mesh_version& mesh, std::span<const facet_id> facets);
/// Triangles over those of the points that they have. Cost: O(triangles log triangles).
[[nodiscard]] facet_corners with_own_points(
  std::span<const vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

/// `fit_wall` for triangles over points, each of which is a corner of some.
[[nodiscard]] std::optional<wall_shape> fit_wall(
  std::span<const vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
  const fit_limits& limits = {});

}  // namespace tedit
