// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/near_boundary.hpp"

#include <algorithm>

#include "mesh/distances.hpp"

namespace tedit::ops {

near_boundary::near_boundary(const mesh_version& mesh, const box& where)
    : mesh_(mesh), tree_(collect(where)) {}

std::vector<near_boundary::crossing> near_boundary::along(vec3 from, vec3 direction,
                                                          double reach) const {
  std::vector<crossing> result;
  (void)tree_.any_meeting(box_of(std::array{from, from + reach * direction}), [&](std::size_t i) {
    const auto hit = ray_through(corners(facets_[i]), from, direction);
    if (hit && hit->distance <= reach)
      result.push_back({hit->distance, hit->leaves, facets_[i]});
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
