// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/tets_in_box.hpp"

#include <algorithm>

namespace tedit::ops {

namespace {

/// With more of the part's facets than this share a look at all tets is the quicker one.
constexpr double many_facets = 0.25;

/// Does an edge of the triangle pass through the inside of a box?
bool an_edge_passes(const mesh_version& mesh, const std::array<vertex_id, 3>& v, const box& where) {
  for (int k = 0; k < 3; ++k) {
    const vec3 from = mesh.position(v[k]);
    const vec3 way = mesh.position(v[(k + 1) % 3]) - from;
    double in = 0;
    double out = 1;
    for (const auto axis : {&vec3::x, &vec3::y, &vec3::z}) {
      const double low = where.low.*axis - from.*axis;
      const double high = where.high.*axis - from.*axis;
      if (way.*axis == 0) {
        out = low < 0 && high > 0 ? out : -1;
        continue;
      }
      in = std::max(in, std::min(low / (way.*axis), high / (way.*axis)));
      out = std::min(out, std::max(low / (way.*axis), high / (way.*axis)));
    }
    if (in < out)
      return true;
  }
  return false;
}

std::vector<tet_id> by_all_boxes(const mesh_version& mesh, const box& where) {
  std::vector<tet_id> result;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t) && where.meets(box_of(mesh.corners(t))))
      result.push_back(t);
  return result;
}

}  // namespace

/// What of the part lies in a box hangs together there, over faces of tets, up to facets that pass
/// through the box; so it is found from these. Where none does, the part fills the box, or has
/// nothing in it.
std::vector<tet_id> tets_in_box(const mesh_version& mesh, const box& where,
                                const std::vector<facet_id>& near) {
  const bool cut = std::ranges::any_of(
    near, [&](facet_id f) { return an_edge_passes(mesh, mesh.facet(f).v, where); });
  if (!cut || static_cast<double>(near.size()) > many_facets * mesh.facet_slots())
    return by_all_boxes(mesh, where);
  std::vector<std::uint8_t> seen(mesh.tet_slots());
  std::vector<tet_id> found;
  const auto add = [&](tet_id t) {
    if (seen[t] || !where.meets(box_of(mesh.corners(t))))
      return;
    seen[t] = 1;
    found.push_back(t);
  };
  for (const auto f : near)
    add(mesh.facet(f).tet);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const auto n : mesh.neighbours(found[i]))
      if (!is_facet(n))
        add(n);
  std::ranges::sort(found);
  return found;
}

std::vector<facet_id> facets_in_box(const mesh_version& mesh, const box& where, box& all) {
  std::vector<facet_id> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& v = mesh.facet(f).v;
    const auto facet =
      box_of(std::array{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])});
    all.add(facet.low);
    all.add(facet.high);
    if (where.meets(facet))
      result.push_back(f);
  }
  return result;
}

}  // namespace tedit::ops
