// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "mesh/vec3.hpp"

namespace tedit {

/// `radius_ratio` (mesh/quality.hpp) in a form that inlines and takes plain square roots: the same
/// number but for rounding, at a quarter of the cost. 0 for a flat or inverted tet.
[[nodiscard]] inline double quick_ratio(vec3 a, vec3 b, vec3 c, vec3 d) {
  const vec3 ab = b - a;
  const vec3 ac = c - a;
  const vec3 ad = d - a;
  const vec3 bc = c - b;
  const vec3 bd = d - b;
  const vec3 cd = d - c;
  const vec3 n = cross(ac, ad);
  const double six_v = dot(ab, n);
  if (!(six_v > 0))
    return 0;
  const auto length = [](vec3 v) { return std::sqrt(dot(v, v)); };
  const double two_area =
    length(n) + length(cross(ab, ad)) + length(cross(ab, ac)) + length(cross(bc, bd));
  const double la = std::sqrt(dot(ab, ab) * dot(cd, cd));
  const double lb = std::sqrt(dot(ac, ac) * dot(bd, bd));
  const double lc = std::sqrt(dot(ad, ad) * dot(bc, bc));
  const double s = 0.5 * (la + lb + lc);
  const double heron = s * (s - la) * (s - lb) * (s - lc);
  if (!(heron > 0) || !(two_area > 0))
    return 0;
  const double q = 3 * six_v * six_v / (two_area * std::sqrt(heron));
  return q < 1 ? q : 1;
}

[[nodiscard]] inline double quick_ratio(const std::array<vec3, 4>& p) {
  return quick_ratio(p[0], p[1], p[2], p[3]);
}

}  // namespace tedit
