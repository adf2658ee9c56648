// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/facet_sheet.hpp"

#include <algorithm>
#include <tuple>

namespace tedit::ops {

namespace {

vec3 nearest_on(vec3 p, const std::array<vec3, 3>& t) {
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

facet_sheet::facet_sheet(const mesh_version& mesh, surface_id id) {
  for (const auto f : facets_of(mesh, std::vector{id})) {
    const auto& v = mesh.facet(f).v;
    triangles_.push_back({mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])});
  }
  if (!triangles_.empty())
    for (int i = 0; i < 3; ++i)
      size_ = std::max(size_, norm(triangles_[0][(i + 1) % 3] - triangles_[0][i]));
}

wall_shape facet_sheet::plane_at(vec3 p) const {
  std::vector<vec3> nearest;
  double least = 1e300;
  for (const auto& t : triangles_) {
    nearest.push_back(nearest_on(p, t));
    least = std::min(least, norm(p - nearest.back()));
  }
  wall_shape plane;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (norm(p - nearest[i]) > least + 1e-6 * size_)
      continue;
    const auto& [a, b, c] = triangles_[i];
    plane.point = nearest[i];
    plane.axis += normalized(area_vector(a, b, c));
  }
  plane.axis = normalized(plane.axis);
  return plane;
}

}  // namespace tedit::ops
