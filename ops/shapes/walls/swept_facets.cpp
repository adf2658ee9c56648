// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/swept_facets.hpp"

#include <algorithm>
#include <vector>

#include "mesh/box_tree.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit::ops {

namespace {

using triangle = std::array<vec3, 3>;

struct swept_facet {
  facet_id facet = no_id;
  triangle before, after;
  box extent;  ///< Of both.
};

/// Is p in the tet, on whichever side its corners are wound?
bool in_tet(vec3 a, vec3 b, vec3 c, vec3 d, vec3 p) {
  const int side = orient3d(a, b, c, d);
  return side != 0 && orient3d(p, b, c, d) == side && orient3d(a, p, c, d) == side &&
         orient3d(a, b, p, d) == side && orient3d(a, b, c, p) == side;
}

/// Does the facet pass the point on its way? The prism it sweeps is looked at as three tets.
bool sweeps(const swept_facet& f, vec3 p) {
  const auto& a = f.before;
  const auto& b = f.after;
  return in_tet(a[0], a[1], a[2], b[0], p) || in_tet(a[1], a[2], b[0], b[1], p) ||
         in_tet(a[2], b[0], b[1], b[2], p);
}

std::vector<swept_facet> facets_in(const mesh_builder& mesh,
                                   const std::map<vertex_id, vec3>& places, bool moved,
                                   const box& within) {
  std::vector<swept_facet> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    swept_facet found{f, {}, {}, {}};
    bool moves = false;
    for (int i = 0; i < 3; ++i) {
      const auto v = mesh.facet(f).v[i];
      const auto place = places.find(v);
      moves = moves || place != places.end();
      found.before[i] = mesh.position(v);
      found.after[i] = place == places.end() ? mesh.position(v) : place->second;
    }
    found.extent.add(found.before);
    found.extent.add(found.after);
    if ((moves || !moved) && found.extent.meets(within))
      result.push_back(found);
  }
  return result;
}

std::vector<box> extents_of(const std::vector<swept_facet>& facets) {
  std::vector<box> result;
  result.reserve(facets.size());
  for (const auto& f : facets)
    result.push_back(f.extent);
  return result;
}

/// Does a facet that moves meet another one that has no corner of it?
bool meet(const mesh_builder& mesh, const swept_facet& f, const swept_facet& g) {
  const auto& mine = mesh.facet(f.facet).v;
  if (std::ranges::any_of(mesh.facet(g.facet).v,
                          [&](vertex_id v) { return std::ranges::count(mine, v) > 0; }))
    return false;
  return triangles_intersect(f.after, g.after) ||
         std::ranges::any_of(g.before, [&](vec3 p) { return sweeps(f, p); });
}

}  // namespace

std::optional<boundary_meeting> first_meeting(const mesh_builder& mesh,
                                              const std::map<vertex_id, vec3>& places) {
  box everywhere;
  everywhere.low = {-1e300, -1e300, -1e300};
  everywhere.high = {1e300, 1e300, 1e300};
  const auto moving = facets_in(mesh, places, true, everywhere);
  box reach;
  for (const auto& f : moving) {
    reach.add(f.extent.low);
    reach.add(f.extent.high);
  }
  const auto others = facets_in(mesh, places, false, reach);
  const box_tree tree(extents_of(others));
  std::vector<std::size_t> near;
  for (const auto& f : moving) {
    near.clear();
    (void)tree.any_meeting(f.extent, [&](std::size_t i) {
      near.push_back(i);
      return false;
    });
    std::ranges::sort(near);  // The first one is told.
    for (const auto i : near)
      if (meet(mesh, f, others[i])) {
        const auto& [p, q, r] = others[i].after;
        return boundary_meeting{mesh.facet(others[i].facet).surface, (p + q + r) / 3};
      }
  }
  return std::nullopt;
}

}  // namespace tedit::ops
