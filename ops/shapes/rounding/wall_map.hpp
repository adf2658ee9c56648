// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "ops/shapes/rounding/rolling_ball.hpp"

namespace tedit::ops {

/// A flat picture of a piece of a wall, counter-clockwise seen from outside: a plane as it is, a
/// cylinder unrolled; a piece that goes all around the cylinder spreads out as a ring, by the map
/// (angle, height) -> e^(height / R) (cos angle, sin angle), which keeps angles.
class wall_map {
public:
  /// @param facets the piece. Cost: O(piece).
  wall_map(const mesh_version& mesh, const wall_shape& shape, std::span<const facet_id> facets);

  [[nodiscard]] std::array<double, 2> flatten(vec3 p) const;

  /// Back onto the exact wall.
  [[nodiscard]] vec3 lift(std::array<double, 2> p) const;

private:
  [[nodiscard]] double angle(vec3 p) const;

  wall_shape shape_;
  vec3 origin_;
  vec3 u_, w_;
  double start_ = 0;  ///< Angle at which an unrolled cylinder is cut, rad.
  bool ring_ = false;
};

}  // namespace tedit::ops
