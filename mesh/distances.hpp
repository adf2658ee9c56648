// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "mesh/vec3.hpp"

namespace tedit {

/// The distance of two segments, m; either may be a point. Cost: O(1).
[[nodiscard]] double segments_apart(vec3 a, vec3 b, vec3 c, vec3 d);

/// The distance of a point from a triangle, m; that may be flat or a point. Cost: O(1).
[[nodiscard]] double point_to_triangle(vec3 p, vec3 a, vec3 b, vec3 c);

/// The point of a triangle, which has an area, that is nearest to p: as shares of its corners.
/// Source: Ericson 2005, Real-time collision detection, 5.1.5. Cost: O(1).
[[nodiscard]] std::array<double, 3> nearest_on_triangle(vec3 p, vec3 a, vec3 b, vec3 c);

/// Where a ray passes through a triangle.
struct triangle_hit {
  double distance = 0;  ///< m, along the unit direction; never behind the origin.
  bool leaves = false;  ///< The ray goes with the triangle's normal.
};

/// Nothing where it does not, or lies in the triangle's plane. Source: Moeller and Trumbore 1997.
/// Cost: O(1).
[[nodiscard]] std::optional<triangle_hit> ray_through(const std::array<vec3, 3>& triangle,
                                                      vec3 origin, vec3 direction);

}  // namespace tedit
