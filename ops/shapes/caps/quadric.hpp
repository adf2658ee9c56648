// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "mesh/vec3.hpp"

namespace tedit::ops {

/// A second-order surface c . (x^2, y^2, z^2, xy, yz, zx, x, y, z, 1) = 0: planes, cylinders, cones
/// and spheres are among them. Coordinates are taken from `origin` in units of `scale`.
struct quadric {
  vec3 origin;
  double scale = 1;  ///< m.
  std::array<double, 10> c{};

  /// The point p + t d on the surface with the smallest |t|, t in m; nothing when the line through
  /// p along the unit vector d misses it.
  [[nodiscard]] std::optional<double> along(vec3 p, vec3 d) const;

  /// Distance of a point from the surface to first order, m: f / |grad f|, positive on the side to
  /// which grad f points.
  [[nodiscard]] double signed_distance(vec3 p) const;
  [[nodiscard]] double distance(vec3 p) const { return std::abs(signed_distance(p)); }

  /// Turns the sides around.
  void flip();
};

/// The quadric nearest to the points: least sum f^2 for a mean squared gradient of 1 (Taubin 1991).
/// Nothing for fewer than 10 points or points that do not span space.
[[nodiscard]] std::optional<quadric> fit_quadric(std::span<const vec3> points);

}  // namespace tedit::ops
