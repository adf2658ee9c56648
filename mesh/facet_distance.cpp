// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/facet_distance.hpp"

#include <algorithm>

#include "mesh/distances.hpp"

namespace tedit {

namespace {

std::vector<box> boxes_of(const std::vector<std::array<vec3, 3>>& triangles) {
  std::vector<box> result;
  result.reserve(triangles.size());
  for (const auto& t : triangles)
    result.push_back(box_of(t));
  return result;
}

}  // namespace

facet_distance::facet_distance(std::vector<std::array<vec3, 3>> triangles)
    : triangles_(std::move(triangles)), tree_(boxes_of(triangles_)) {
  for (const auto& [a, b, c] : triangles_) {
    const vec3 centre = (a + b + c) / 3;
    balls_.push_back({centre, std::max({norm(a - centre), norm(b - centre), norm(c - centre)})});
  }
}

/// Surely, by the ball alone: what is far off is not worth a closer look.
bool facet_distance::further(std::size_t i, vec3 p, double than) const {
  const vec3 d = p - balls_[i].centre;
  const double most = than + balls_[i].radius;
  return dot(d, d) > most * most;
}

double facet_distance::operator()(vec3 p, double at_most) const {
  double nearest = at_most;
  box point;
  point.add(p);
  // Shrinks as nearer ones are found: the tree compares with what it is then.
  box within = point.grown(nearest);
  (void)tree_.any_meeting(within, [&](std::size_t i) {
    if (further(i, p, nearest))
      return false;
    const auto& [a, b, c] = triangles_[i];
    if (const double d = point_to_triangle(p, a, b, c); d < nearest) {
      nearest = d;
      within = point.grown(nearest);
    }
    return nearest == 0;
  });
  return nearest;
}

bool facet_distance::is_within(vec3 p, double distance) const {
  box point;
  point.add(p);
  return tree_.any_meeting(point.grown(distance), [&](std::size_t i) {
    const auto& [a, b, c] = triangles_[i];
    return !further(i, p, distance) && point_to_triangle(p, a, b, c) < distance;
  });
}

}  // namespace tedit
