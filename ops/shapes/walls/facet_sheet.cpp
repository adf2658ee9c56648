// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/facet_sheet.hpp"

#include <algorithm>
#include <tuple>

namespace tedit::ops {

namespace {

using triangle = std::array<vec3, 3>;

/// Points so near to each other, as a share of the size, are one.
constexpr double same_place = 1e-6;
/// What a place on a facet may be outside of its box, likewise.
constexpr double rounding = 1e-9;
constexpr double infinite = 1e300;

std::vector<triangle> triangles_of(const mesh_version& mesh, surface_id id) {
  std::vector<triangle> result;
  for (const auto f : facets_of(mesh, std::vector{id})) {
    const auto& v = mesh.facet(f).v;
    result.push_back({mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])});
  }
  return result;
}

std::vector<box> boxes_of(const std::vector<triangle>& triangles) {
  std::vector<box> result;
  for (const auto& t : triangles)
    result.push_back(box_of(t));
  return result;
}

vec3 nearest_on(vec3 p, const triangle& t) {
  const vec3 n = area_vector(t[0], t[1], t[2]);
  vec3 best;
  double least = 1e300;
  bool inside = true;
  for (int i = 0; i < 3; ++i) {
    const vec3 along = t[(i + 1) % 3] - t[i];
    const vec3 d = p - t[i];
    inside = inside && dot(cross(along, d), n) >= 0;
    const vec3 foot = t[i] + std::clamp(dot(d, along) / dot(along, along), 0.0, 1.0) * along;
    if (norm(p - foot) < least)
      std::tie(least, best) = std::tuple(norm(p - foot), foot);
  }
  return inside ? p - dot(p - t[0], n) / dot(n, n) * n : best;
}

}  // namespace

facet_sheet::facet_sheet(const mesh_version& mesh, surface_id id)
    : triangles_(triangles_of(mesh, id)), tree_(boxes_of(triangles_)) {
  if (!triangles_.empty())
    for (int i = 0; i < 3; ++i)
      size_ = std::max(size_, norm(triangles_[0][(i + 1) % 3] - triangles_[0][i]));
}

/// m: of the facet that is nearest to p; looks further and further away.
double facet_sheet::least_distance(vec3 p) const {
  double least = infinite;
  for (double reach = size_; least > reach && reach < infinite; reach *= 2)
    visit_within(p, reach, [&](std::size_t i) {
      least = std::min(least, norm(p - nearest_on(p, triangles_[i])));
    });
  return least;
}

wall_shape facet_sheet::plane_at(vec3 p) const {
  const double reach = least_distance(p) + same_place * size_;
  std::vector<std::size_t> near;
  if (reach < infinite)
    visit_within(p, reach, [&](std::size_t i) { near.push_back(i); });
  std::ranges::sort(near);  // A sum depends on its order.
  wall_shape plane;
  for (const auto i : near) {
    const vec3 at = nearest_on(p, triangles_[i]);
    if (norm(p - at) > reach)
      continue;
    const auto& [a, b, c] = triangles_[i];
    plane.point = at;
    plane.axis += normalized(area_vector(a, b, c));
  }
  plane.axis = normalized(plane.axis);
  return plane;
}

template <class Visit>
void facet_sheet::visit_within(vec3 p, double reach, const Visit& visit) const {
  box around;
  around.add(p);
  (void)tree_.any_meeting(around.grown(reach + rounding * size_), [&](std::size_t i) {
    visit(i);
    return false;
  });
}

}  // namespace tedit::ops
