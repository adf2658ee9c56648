// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/deform/moved_boundary.hpp"

#include <algorithm>

#include "mesh/box_tree.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/predicates.hpp"

namespace tedit::ops {

namespace {

bool share_a_vertex(const boundary_facet& a, const boundary_facet& b) {
  return std::ranges::any_of(a.v, [&](vertex_id v) { return std::ranges::count(b.v, v) > 0; });
}

}  // namespace

moved_boundary::moved_boundary(const mesh_version& mesh, std::vector<vertex_id> moved)
    : mesh_(mesh), moved_(std::move(moved)) {
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f) && std::ranges::any_of(mesh.facet(f).v, [&](vertex_id v) {
          return std::ranges::binary_search(moved_, v);
        }))
      facets_.push_back(f);
}

std::array<vec3, 3> moved_boundary::triangle(facet_id f, std::span<const vec3> places) const {
  std::array<vec3, 3> result;
  for (int i = 0; i < 3; ++i) {
    const auto v = mesh_.facet(f).v[i];
    const auto at = std::ranges::lower_bound(moved_, v);
    result[i] = !places.empty() && at != moved_.end() && *at == v
                  ? places[static_cast<std::size_t>(at - moved_.begin())]
                  : mesh_.position(v);
  }
  return result;
}

expected<std::optional<collision>> moved_boundary::meets_itself(std::span<const vec3> places,
                                                                const cancel_token& cancel) const {
  std::vector<std::array<vec3, 3>> now;
  box all;
  for (const auto f : facets_) {
    now.push_back(triangle(f, places));
    all.add(now.back());
  }
  std::vector<facet_id> near(facets_);
  for_each_facet_near(mesh_, all, [&](facet_id f) {
    if (!std::ranges::binary_search(facets_, f))
      near.push_back(f);
  });
  std::vector<box> boxes;
  for (std::size_t i = 0; i < near.size(); ++i)
    boxes.push_back(box_of(i < now.size() ? now[i] : triangle(near[i], {})));
  const box_tree tree(boxes);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (i % 256 == 0 && cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    std::optional<collision> found;
    (void)tree.any_meeting(boxes[i], [&](std::size_t j) {
      if (j == i || share_a_vertex(mesh_.facet(facets_[i]), mesh_.facet(near[j])))
        return false;
      const auto other = j < now.size() ? now[j] : triangle(near[j], {});
      if (!triangles_intersect(now[i], other) ||
          triangles_intersect(triangle(facets_[i], {}), triangle(near[j], {})))
        return false;
      found = collision{mesh_.facet(facets_[i]).surface, mesh_.facet(near[j]).surface,
                        (now[i][0] + now[i][1] + now[i][2]) / 3};
      return true;
    });
    if (found)
      return found;
  }
  return std::optional<collision>();
}

}  // namespace tedit::ops
