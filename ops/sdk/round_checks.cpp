// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/box.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/place_text.hpp"
#include "mesh/predicates.hpp"
#include "ops/sdk/round_boundary.hpp"
#include "ops/sdk/round_cavity.hpp"

namespace tedit::ops {

namespace {

/// How often the shell goes round a point: 1 inside, 0 outside. Sum of solid angles (van Oosterom
/// and Strackee 1983).
double winding(const closed_surface& shell, vec3 p) {
  double sum = 0;
  for (const auto& t : shell.triangles) {
    const vec3 a = shell.points[t[0]] - p;
    const vec3 b = shell.points[t[1]] - p;
    const vec3 c = shell.points[t[2]] - p;
    const double la = norm(a);
    const double lb = norm(b);
    const double lc = norm(c);
    sum += std::atan2(dot(a, cross(b, c)),
                      la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

/// No triangle of the shell nearer than `distance`, and the point inside it.
bool has_room(const closed_surface& shell, vec3 p, double distance) {
  for (const auto& t : shell.triangles) {
    const vec3 a = shell.points[t[0]];
    const vec3 b = shell.points[t[1]];
    const vec3 c = shell.points[t[2]];
    const vec3 low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})};
    const vec3 high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}),
                    std::max({a.z, b.z, c.z})};
    if (p.x < low.x - distance || p.y < low.y - distance || p.z < low.z - distance ||
        p.x > high.x + distance || p.y > high.y + distance || p.z > high.z + distance)
      continue;
    if (point_to_triangle(p, a, b, c) < distance)
      return false;
  }
  return winding(shell, p) > 0.5;
}

}  // namespace

void add_depth(const round_surface& made, round_shell& shell) {
  std::vector<vec3> added;
  for (std::size_t i = 0; i < made.triangles.size(); i += 2) {
    const auto& t = made.triangles[i];
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
    const vec3 p = middle - depth * normalized(area);
    if (std::ranges::all_of(added, [&](vec3 q) { return norm(q - p) >= 0.8 * depth; }) &&
        has_room(shell.surface, p, 0.6 * depth))
      added.push_back(p);
  }
  auto& points = shell.surface.points;
  points.insert(points.end(), added.begin(), added.end());
  shell.vertices.resize(points.size(), no_id);
}

expected<void> check_free(const mesh_version& mesh, const round_plan& plan,
                          const round_shell& shell) {
  const auto& points = shell.surface.points;
  struct placed {
    std::array<vec3, 3> p;
    std::array<std::uint32_t, 3> index;
    box extent;
  };
  std::vector<placed> fresh;
  box all;
  for (std::size_t i = shell.kept; i < shell.surface.triangles.size(); ++i) {
    const auto& t = shell.surface.triangles[i];
    placed one{{points[t[0]], points[t[1]], points[t[2]]}, t, {}};
    one.extent = box_of(one.p);
    for (const auto& p : one.p)
      all.add(p);
    fresh.push_back(one);
  }
  expected<void> result;
  for_each_facet_near(mesh, all, [&](facet_id f) {
    const auto& v = mesh.facet(f).v;
    const std::array<vec3, 3> p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    const auto extent = box_of(p);
    if (!result || !extent.meets(all) || shell.replaced.contains(f))
      return;
    const bool meets = std::ranges::any_of(fresh, [&](const placed& one) {
      return one.extent.meets(extent) &&
             std::ranges::none_of(one.index,
                                  [&](std::uint32_t k) {
                                    return shell.vertices[k] != no_id &&
                                           std::ranges::count(v, shell.vertices[k]) > 0;
                                  }) &&
             triangles_intersect(one.p, p);
    });
    if (meets)
      result =
        fail(ec::cap_intersects,
             "the rounding of " + plan.chains.front().name(mesh) + " would run into surface " +
               std::to_string(mesh.facet(f).surface) + " at " + place_text(p[0]),
             "Take a smaller radius");
  });
  return result;
}

}  // namespace tedit::ops
