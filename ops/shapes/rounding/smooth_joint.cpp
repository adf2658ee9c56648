// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/smooth_joint.hpp"

#include <cmath>

namespace tedit::ops {

namespace {

/// Of the radius: by so much the corner is left to see how the walls differ; and what they differ
/// by then, where they are not one.
constexpr double small = 1e-3;
constexpr double least_change = small * small;

/// As two walls touch along the line between them, what their normals differ by grows with the
/// distance from it: a function that is 0 there, below and above on either side.
std::function<double(vec3)> side_of_joint(const exact_wall& one, const exact_wall& other,
                                          vec3 corner, double radius) {
  const auto apart = [&one, &other](vec3 q) { return other.normal(q) - one.normal(q); };
  const vec3 n = one.normal(corner);
  const vec3 u = normalized(cross(n, std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0}));
  const vec3 here = apart(corner);
  vec3 most;
  for (const vec3 way : {u, cross(n, u)})
    if (const vec3 change = apart(corner + small * radius * way) - here; norm(change) > norm(most))
      most = change;
  if (norm(most) < least_change)
    return {};
  return [apart, here, m = normalized(most)](vec3 q) { return dot(apart(q) - here, m); };
}

}  // namespace

std::optional<std::array<vec3, 2>> centres_at_joint(const std::array<joint_end, 2>& ends,
                                                    vec3 corner) {
  const double radius = ends[0].ball.radius();
  const auto side = side_of_joint(ends[0].outer(), ends[1].outer(), corner, radius);
  if (!side)
    return std::nullopt;
  std::array<vec3, 2> centres;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto start = ends[i].ball.centre(corner);
    const auto found =
      start ? ends[i].ball.centre_where(ends[i].outer_is_b ? 1 : 0, side, *start) : std::nullopt;
    if (!found)
      return std::nullopt;
    centres[i] = *found;
  }
  if (norm(centres[1] - centres[0]) > arcs_match * radius)
    return std::nullopt;
  return centres;
}

}  // namespace tedit::ops
