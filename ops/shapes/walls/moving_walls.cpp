// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/moving_walls.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/level_set_patch.hpp"
#include "ops/shapes/walls/carried_surfaces.hpp"

namespace tedit::ops {

namespace {

std::string text_of(const char* format, double a) {
  char text[96];
  std::snprintf(text, sizeof(text), format, a);
  return text;
}

/// Mean radius change of the cylinders, each fitted anew to where its vertices are now; nothing
/// without.
std::optional<double> radius_change(const mesh_version& after, const wall_set& walls) {
  double sum = 0;
  int round = 0;
  for (const auto& [id, wall] : walls) {
    if (!wall.is(wall_shape::kind::cylinder))
      continue;
    const auto fitted = fit_wall(after, facets_of(after, std::vector{id}), round_enough);
    if (!fitted || fitted->type != wall_shape::kind::cylinder)
      return std::nullopt;
    sum += fitted->radius - wall.exact->radius;
    ++round;
  }
  return round > 0 ? std::optional(sum / round) : std::nullopt;
}

/// Facets of a surface that differ by more than this cosine are on two sides of a crease.
constexpr double crease_cosine = 0.85;

double angle_at(const std::array<vec3, 3>& p, int corner) {
  const vec3 a = p[(corner + 1) % 3] - p[corner];
  const vec3 b = p[(corner + 2) % 3] - p[corner];
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// Of the facets at each corner, weighted by their angles there (Thuermer and Wuethrich 1998).
std::unordered_map<vertex_id, std::vector<vec3>> normals_of(const mesh_version& mesh,
                                                            std::span<const facet_id> facets) {
  std::unordered_map<vertex_id, std::vector<vec3>> sums;
  for (const auto f : facets) {
    const auto& v = mesh.facet(f).v;
    const std::array p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    const vec3 normal = normalized(area_vector(p[0], p[1], p[2]));
    for (int i = 0; i < 3; ++i) {
      auto& at = sums[v[i]];
      const auto side = std::ranges::find_if(
        at, [&](vec3 sum) { return dot(normalized(sum), normal) > crease_cosine; });
      const vec3 part = angle_at(p, i) * normal;
      if (side == at.end())
        at.push_back(part);
      else
        *side += part;
    }
  }
  for (auto& [v, at] : sums)
    for (auto& sum : at)
      sum = normalized(sum);
  return sums;
}

}  // namespace

double moving_wall::rise(vertex_id v, vec3 before, vec3 p) const {
  if (exact)
    return exact->distance(p) - exact->distance(before);
  const auto at = normals.find(v);
  if (at == normals.end())
    return 0;
  double sum = 0;
  for (const auto& normal : at->second)
    sum += dot(normal, p - before);
  return sum / static_cast<double>(at->second.size());
}

expected<wall_set> fit_walls(const mesh_version& mesh, const std::vector<surface_id>& surfaces) {
  wall_set walls;
  for (const auto id : surfaces) {
    const auto facets = facets_of(mesh, std::vector{id});
    if (facets.empty())
      return fail(ec::empty_selection,
                  "surface " + std::to_string(id) +
                    " has no outer side: it lies between two regions, or is gone already",
                  "Select surfaces of the outside");
    moving_wall wall{fit_wall(mesh, facets, round_enough), {}};
    if (!wall.exact)
      wall.normals = normals_of(mesh, facets);
    walls.emplace(id, std::move(wall));
  }
  return walls;
}

expected<void> check_room(const wall_set& walls, double distance) {
  for (const auto& [id, wall] : walls)
    if (const auto& shape = wall.exact;
        wall.is(wall_shape::kind::cylinder) &&
        shape->radius + shape->side * distance <= 1e-3 * shape->radius)
      return fail(
        ec::invalid_argument,
        "surface " + std::to_string(id) + " is round with a radius of " +
          text_of("%.4g mm; it cannot be moved by as much towards its axis", 1e3 * shape->radius),
        distance < 0 ? "" : "Fill the hole (fill_hole) instead");
  return {};
}

expected<bool> all_flat(const mesh_builder& mesh, const std::vector<surface_id>& surfaces) {
  for (const auto surface : surfaces) {
    const auto patch = find_patch(mesh, surface);
    if (!patch)
      return fail(patch.error());
    if (!patch->flat())
      return false;
  }
  return true;
}

std::vector<figure> measure_shift(const mesh_version& base, const mesh_version& mesh,
                                  const wall_set& selected, double distance) {
  auto walls = selected;
  find_carried(base, walls, distance);
  double area = 0;
  double mean = 0;
  double worst = distance;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& facet = mesh.facet(f);
    const auto wall = walls.find(facet.surface);
    if (wall == walls.end())
      continue;
    const double share = norm(
      area_vector(mesh.position(facet.v[0]), mesh.position(facet.v[1]), mesh.position(facet.v[2])));
    area += share;
    for (const auto v : facet.v) {
      // Walls make no vertices of their own: each was on the wall before.
      const double rise = wall->second.rise(v, base.position(v), mesh.position(v));
      mean += share * rise / 3;
      if (std::abs(rise - distance) > std::abs(worst - distance))
        worst = rise;
    }
  }
  const double sign = distance < 0 ? -1 : 1;
  const char* what = distance < 0 ? "thickness taken off" : "thickness put on";
  std::vector<figure> figures;
  if (area == 0)
    return figures;
  figures.push_back({"thickness_change_mm", sign * 1e3 * mean / area, "mm", what});
  figures.push_back(
    {"thickness_change_worst_mm", sign * 1e3 * worst, "mm",
     distance < 0 ? "taken off at the least exact place" : "put on at the least exact place"});
  if (const auto change = radius_change(mesh, walls))
    figures.push_back({"radius_change_mm", 1e3 * *change, "mm", "change of the radius, fitted"});
  return figures;
}

}  // namespace tedit::ops
