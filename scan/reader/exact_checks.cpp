// SPDX-License-Identifier: AGPL-3.0-or-later
// What CGAL does here; its headers take long to compile.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "scan/reader/mend.hpp"

namespace tedit::scan {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using cgal_mesh = CGAL::Surface_mesh<kernel::Point_3>;

}  // namespace

expected<void> check_intersections(const triangle_surface& surface) {
  cgal_mesh mesh;
  std::vector<cgal_mesh::Vertex_index> vertices;
  for (const auto& p : surface.points)
    vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& t : surface.triangles)
    if (mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) == cgal_mesh::null_face())
      return fail(ec::non_manifold, "the triangles do not make up one closed surface",
                  "Repair it in the program that the file comes from");
  std::vector<std::pair<cgal_mesh::Face_index, cgal_mesh::Face_index>> pairs;
  pmp::self_intersections<CGAL::Sequential_tag>(mesh, std::back_inserter(pairs));
  if (pairs.empty())
    return {};
  const auto first = *std::min_element(pairs.begin(), pairs.end());
  const auto& t = surface.triangles[first.first];
  const vec3 middle = (surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]) / 3;
  return fail(ec::bad_input,
              "the surface goes through itself: " + std::to_string(pairs.size()) +
                (pairs.size() == 1 ? " pair of triangles cuts or covers each other"
                                   : " pairs of triangles cut or cover each other") +
                ", the first at " + place_of(middle),
              "Unite its parts in the program that the file comes from, or repair it there");
}

std::vector<triangle_corners> fill_loop(const std::vector<vec3>& loop) {
  std::vector<kernel::Point_3> points;
  for (const auto& p : loop)
    points.emplace_back(p.x, p.y, p.z);
  std::vector<CGAL::Triple<int, int, int>> found;
  pmp::triangulate_hole_polyline(points, std::back_inserter(found));
  std::vector<triangle_corners> triangles;
  for (const auto& [a, b, c] : found)
    triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                         static_cast<std::uint32_t>(c)});
  return triangles;
}

}  // namespace tedit::scan
