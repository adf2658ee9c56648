// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_cavity.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/box_tree.hpp"
#include "mesh/distances.hpp"
#include "mesh/quality.hpp"

namespace tedit::ops {

namespace {

bool pierces(vec3 p, vec3 q, vec3 a, vec3 b, vec3 c) {
  const double from = signed_volume(a, b, c, p);
  const double to = signed_volume(a, b, c, q);
  if ((from > 0) == (to > 0))
    return false;
  const bool s = signed_volume(p, q, a, b) > 0;
  return (signed_volume(p, q, b, c) > 0) == s && (signed_volume(p, q, c, a) > 0) == s;
}

}  // namespace

double segment_to_tet(vec3 a, vec3 b, const std::array<vec3, 4>& corners) {
  double nearest = 1e300;
  bool inside = true;
  for (const auto& face : tet_faces) {
    const vec3 p = corners[face[0]];
    const vec3 q = corners[face[1]];
    const vec3 r = corners[face[2]];
    inside = inside && dot(a - p, area_vector(p, q, r)) <= 0;
    if (pierces(a, b, p, q, r))
      return 0;
    nearest = std::min({nearest, point_to_triangle(a, p, q, r), point_to_triangle(b, p, q, r),
                        segments_apart(a, b, p, q), segments_apart(a, b, q, r),
                        segments_apart(a, b, r, p)});
  }
  return inside ? 0 : nearest;
}

expected<std::unordered_set<tet_id>> find_cavity(const mesh_version& mesh, const round_plan& plan,
                                                 const round_surface& made,
                                                 const std::vector<vertex_id>& whole,
                                                 double margin) {
  std::vector<vertex_id> seeds = whole;
  for (const auto& chain : plan.chains)
    seeds.insert(seeds.end(), chain.path.begin(), chain.path.end());
  auto found = tets_around(mesh, seeds);
  std::unordered_set<tet_id> cavity(found.begin(), found.end());
  std::vector<box> boxes;
  for (const auto& r : made.reach)
    boxes.push_back(box_of(std::array{r.from, r.to}).grown(r.radius + margin));
  const box_tree reach(boxes);
  const auto near = [&](tet_id t) {
    const auto c = mesh.corners(t);
    return reach.any_meeting(box_of(c), [&](std::size_t i) {
      const auto& r = made.reach[i];
      return segment_to_tet(r.from, r.to, c) < r.radius + margin;
    });
  };
  std::unordered_set<tet_id> seen = cavity;
  for (std::size_t next = 0; next < found.size(); ++next)
    for (const auto behind : mesh.neighbours(found[next]))
      if (!is_facet(behind) && seen.insert(behind).second && near(behind)) {
        cavity.insert(behind);
        found.push_back(behind);
      }
  for (const auto t : found)
    if (mesh.region_of(t) != mesh.region_of(found.front()))
      return fail(ec::invalid_argument, plan.chains.front().name(mesh) + " lies where regions " +
                                          std::to_string(mesh.region_of(found.front())) + " and " +
                                          std::to_string(mesh.region_of(t)) + " meet");
  return cavity;
}

}  // namespace tedit::ops
