// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "mesh/vec3.hpp"

namespace tedit::ops {

/// A rigid motion or a reflection: p goes to A p + shift.
struct motion {
  std::array<vec3, 3> columns{vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}};  ///< Of A.
  vec3 shift;                                                                ///< m.
  bool mirrors = false;

  [[nodiscard]] vec3 turned(vec3 direction) const {
    return direction.x * columns[0] + direction.y * columns[1] + direction.z * columns[2];
  }
  [[nodiscard]] vec3 operator()(vec3 p) const { return turned(p) + shift; }
};

/// By a vector, m.
[[nodiscard]] inline motion shift_by(vec3 way) {
  motion result;
  result.shift = way;
  return result;
}

/// By an angle (rad, right-handed) around an axis through a point (m); `axis` is unit.
[[nodiscard]] inline motion turn_around(vec3 point, vec3 axis, double angle) {
  motion result;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (auto& e : result.columns)  // Rodrigues' formula.
    e = c * e + s * cross(axis, e) + (1 - c) * dot(axis, e) * axis;
  result.shift = point - result.turned(point);
  return result;
}

/// In the plane through a point (m) with this unit normal.
[[nodiscard]] inline motion mirror_in(vec3 point, vec3 normal) {
  motion result;
  for (auto& e : result.columns)
    e = e - 2 * dot(normal, e) * normal;
  result.shift = 2 * dot(normal, point) * normal;
  result.mirrors = true;
  return result;
}

}  // namespace tedit::ops
