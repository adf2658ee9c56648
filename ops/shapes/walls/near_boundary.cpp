// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/near_boundary.hpp"

#include <algorithm>
#include <optional>

namespace tedit::ops {

namespace {

/// Moeller and Trumbore 1997.
std::optional<near_boundary::crossing> hit(const std::array<vec3, 3>& p, vec3 from,
                                           vec3 direction) {
  const vec3 one = p[1] - p[0];
  const vec3 two = p[2] - p[0];
  const vec3 across = cross(direction, two);
  const double det = dot(one, across);
  if (det == 0)
    return std::nullopt;
  const vec3 start = from - p[0];
  const double u = dot(start, across) / det;
  const vec3 q = cross(start, one);
  const double v = dot(direction, q) / det;
  if (!(u >= 0 && v >= 0 && u + v <= 1))
    return std::nullopt;
  return near_boundary::crossing{dot(two, q) / det, dot(cross(one, two), direction) > 0, no_id};
}

}  // namespace

near_boundary::near_boundary(const mesh_version& mesh, const box& where)
    : mesh_(mesh), tree_(collect(where)) {}

std::vector<near_boundary::crossing> near_boundary::along(vec3 from, vec3 direction,
                                                          double reach) const {
  std::vector<crossing> result;
  (void)tree_.any_meeting(box_of(std::array{from, from + reach * direction}), [&](std::size_t i) {
    auto found = hit(corners(facets_[i]), from, direction);
    if (found && found->distance >= 0 && found->distance <= reach) {
      found->facet = facets_[i];
      result.push_back(*found);
    }
    return false;
  });
  std::ranges::sort(result, {}, &crossing::distance);
  return result;
}

std::vector<box> near_boundary::collect(const box& where) {
  std::vector<box> boxes;
  for (facet_id f = 0; f < mesh_.facet_slots(); ++f) {
    if (!mesh_.is_live_facet(f))
      continue;
    const auto around = box_of(corners(f));
    if (!where.meets(around))
      continue;
    facets_.push_back(f);
    boxes.push_back(around);
  }
  return boxes;
}

std::array<vec3, 3> near_boundary::corners(facet_id f) const {
  const auto& v = mesh_.facet(f).v;
  return {mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])};
}

}  // namespace tedit::ops
