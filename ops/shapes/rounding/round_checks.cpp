// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "mesh/box_tree.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/place_text.hpp"
#include "ops/shapes/new_triangles.hpp"
#include "ops/shapes/rounding/round_boundary.hpp"
#include "ops/shapes/rounding/surface_tree.hpp"

namespace tedit::ops {

namespace {

/// A place in the material behind two rounded triangles.
struct deep_place {
  vec3 at;
  vec3 outward;      ///< Their normal, not of unit length.
  double depth = 0;  ///< m.
};

deep_place behind(const round_surface& made, std::size_t triangle) {
  const auto& t = made.triangles[triangle];
  const vec3 a = made.points[t[0]];
  const vec3 b = made.points[t[1]];
  const vec3 c = made.points[t[2]];
  // The middle of the longest side is about the middle of the pair.
  vec3 middle = 0.5 * (a + b);
  double longest = norm(a - b);
  for (const auto& [p, q] : {std::pair(b, c), std::pair(c, a)})
    if (norm(p - q) > longest)
      std::tie(middle, longest) = std::tuple(0.5 * (p + q), norm(p - q));
  const vec3 area = area_vector(a, b, c);
  const double depth = 0.6 * std::sqrt(2 * norm(area));
  return {middle - depth * normalized(area), area, depth};
}

}  // namespace

void add_depth(const round_surface& made, round_shell& shell) {
  std::vector<deep_place> places;
  std::vector<box> boxes;
  for (std::size_t i = 0; i < made.triangles.size(); i += 2) {
    places.push_back(behind(made, i));
    boxes.push_back({places.back().at, places.back().at});
  }
  const box_tree near(boxes);
  const surface_tree surface(shell.surface);
  std::vector<bool> taken(places.size(), false);
  std::vector<vec3> added;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const vec3 p = places[i].at;
    const double depth = places[i].depth;
    const bool crowded = near.any_meeting(boxes[i].grown(0.8 * depth), [&](std::size_t k) {
      return taken[k] && norm(places[k].at - p) < 0.8 * depth;
    });
    // Across the rounded surface: along it the ray would pass by all of its triangles.
    if (crowded || surface.comes_within(p, 0.6 * depth) ||
        surface.winding(p, places[i].outward) < 1)
      continue;
    taken[i] = true;
    added.push_back(p);
  }
  auto& points = shell.surface.points;
  points.insert(points.end(), added.begin(), added.end());
  shell.vertices.resize(points.size(), no_id);
}

expected<void> check_free(const mesh_version& mesh, const round_plan& plan,
                          const round_shell& shell) {
  const new_triangles made(shell.surface, shell.vertices, shell.kept);
  expected<void> result;
  for_each_facet_near(mesh, made.extent(), [&](facet_id f) {
    if (!result || shell.replaced.contains(f))
      return;
    const auto& v = mesh.facet(f).v;
    const std::array p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    if (made.meet(v, p))
      result =
        fail(ec::cap_intersects,
             "the rounding of " + plan.chains.front().name(mesh) + " would run into surface " +
               std::to_string(mesh.facet(f).surface) + " at " + place_text(p[0]));
  });
  return result;
}

}  // namespace tedit::ops
