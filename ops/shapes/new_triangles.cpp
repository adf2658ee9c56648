// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/new_triangles.hpp"

#include <algorithm>

#include "mesh/predicates.hpp"

namespace tedit::ops {

namespace {

std::vector<box> boxes_of(const closed_surface& surface, std::size_t first) {
  std::vector<box> boxes;
  for (std::size_t i = first; i < surface.triangles.size(); ++i) {
    const auto& t = surface.triangles[i];
    boxes.push_back(
      box_of(std::array{surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]}));
  }
  return boxes;
}

}  // namespace

new_triangles::new_triangles(const closed_surface& surface, const std::vector<vertex_id>& vertices,
                             std::size_t first)
    : surface_(surface), vertices_(vertices), first_(first), tree_(boxes_of(surface, first)) {}

std::array<vec3, 3> new_triangles::at(std::size_t i) const {
  const auto& t = surface_.triangles[first_ + i];
  return {surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]};
}

bool new_triangles::meet(const std::array<vertex_id, 3>& corners,
                         const std::array<vec3, 3>& places) const {
  const auto in_common = [&](std::uint32_t point) {
    const auto v = vertices_[point];
    return v != no_id && std::ranges::find(corners, v) != corners.end();
  };
  return tree_.any_meeting(box_of(places), [&](std::size_t i) {
    return std::ranges::none_of(surface_.triangles[first_ + i], in_common) &&
           triangles_intersect(at(i), places);
  });
}

}  // namespace tedit::ops
