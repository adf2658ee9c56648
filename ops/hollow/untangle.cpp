// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/untangle.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace tedit::ops {

namespace {

using exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<exact_kernel::Point_3>;

constexpr int rounds = 6;

/// Vertices of triangles that meet others beside their common corners; nothing where the surface is
/// no manifold.
std::optional<std::set<std::uint32_t>> tangled(const closed_surface& from) {
  surface mesh;
  std::vector<surface::Vertex_index> vertices;
  for (const auto& p : from.points)
    vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& t : from.triangles)
    if (mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) == surface::null_face())
      return std::nullopt;
  std::vector<std::pair<surface::Face_index, surface::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  std::set<std::uint32_t> result;
  for (const auto& pair : pairs)
    for (const auto f : {pair.first, pair.second})
      for (const auto v : from.triangles[f.idx()])
        result.insert(v);
  return result;
}

}  // namespace

bool untangle(contoured_surface& contour) {
  for (int i = 0; i < rounds; ++i) {
    const auto bad = tangled(contour.surface);
    if (!bad)
      return false;
    if (bad->empty())
      return true;
    for (const auto v : *bad)
      contour.surface.points[v] = contour.middles[v];
  }
  return false;
}

}  // namespace tedit::ops
