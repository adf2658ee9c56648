// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/level_set_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

namespace tedit {

namespace {

vec3 area_of(const mesh_builder& mesh, facet_id f) {
  const auto& v = mesh.facet(f).v;
  return area_vector(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]));
}

std::uint64_t edge_key(vertex_id a, vertex_id b) {
  return std::uint64_t{a} << 32 | b;
}

double material_angle(const mesh_builder& mesh, const patch_edge& edge) {
  const vec3 n1 = normalized(area_of(mesh, edge.inner));
  const vec3 n2 = normalized(area_of(mesh, edge.outer));
  const vec3 along = normalized(mesh.position(edge.b) - mesh.position(edge.a));
  return std::numbers::pi - std::atan2(dot(along, cross(n1, n2)), dot(n1, n2));
}

/// The border edges of the facets, with the facets across.
expected<std::vector<patch_edge>> border_of(const mesh_builder& mesh,
                                            const std::vector<facet_id>& facets,
                                            surface_id surface) {
  std::unordered_set<std::uint64_t> own;
  for (const auto f : facets)
    for (int i = 0; i < 3; ++i)
      own.insert(edge_key(mesh.facet(f).v[i], mesh.facet(f).v[(i + 1) % 3]));
  std::vector<patch_edge> border;
  std::unordered_map<std::uint64_t, std::size_t> row_of;
  for (const auto f : facets)
    for (int i = 0; i < 3; ++i) {
      const auto a = mesh.facet(f).v[i];
      const auto b = mesh.facet(f).v[(i + 1) % 3];
      if (own.contains(edge_key(b, a)))
        continue;
      row_of.emplace(edge_key(b, a), border.size());
      border.push_back({a, b, f, no_id, 0});
    }
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) || mesh.facet(f).surface == surface)
      continue;
    const auto& v = mesh.facet(f).v;
    for (int i = 0; i < 3; ++i)
      if (const auto row = row_of.find(edge_key(v[i], v[(i + 1) % 3])); row != row_of.end())
        border[row->second].outer = f;
  }
  for (auto& edge : border) {
    if (edge.outer == no_id)
      return fail(ec::non_manifold,
                  "the boundary is not a clean surface at edge " + std::to_string(edge.a) + "-" +
                    std::to_string(edge.b),
                  "Repair the mesh there first");
    edge.angle = material_angle(mesh, edge);
  }
  return border;
}

void measure(const mesh_builder& mesh, surface_patch& patch) {
  vec3 area;
  vec3 weighted;
  double total = 0;
  vec3 low{1e300, 1e300, 1e300};
  vec3 high{-1e300, -1e300, -1e300};
  for (const auto f : patch.facets) {
    const auto& v = mesh.facet(f).v;
    const vec3 a = area_of(mesh, f);
    area += a;
    total += norm(a);
    for (int i = 0; i < 3; ++i) {
      const vec3 p = mesh.position(v[i]);
      weighted += (norm(a) / 3) * p;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      patch.mean_edge += norm(mesh.position(v[(i + 1) % 3]) - p);
    }
  }
  patch.mean_edge /= 3.0 * static_cast<double>(patch.facets.size());
  patch.origin = weighted / total;
  patch.normal = normalized(area);
  patch.size = norm(high - low);
  // Walls around a hole have no direction in common, however near they lie to some plane.
  if (norm(area) < 0.5 * total)
    patch.deviation = patch.size;
  for (const auto f : patch.facets)
    for (const auto v : mesh.facet(f).v)
      patch.deviation = std::max(patch.deviation, std::abs(patch.depth(mesh.position(v))));
}

/// Joins a border edge to a run that it continues in a straight line, at either end.
bool extend(patch_wall& wall, vec3 a, vec3 b, vec3 outward, double tolerance) {
  if (dot(outward, wall.outward) < 1 - 1e-9 || std::abs(wall.across(a)) > tolerance ||
      std::abs(wall.across(b)) > tolerance)
    return false;
  const double first = wall.position(a);
  const double last = wall.position(b);
  if (std::abs(first - wall.length) <= tolerance) {
    wall.length = last;
    return true;
  }
  if (std::abs(last) <= tolerance) {
    wall.origin = a;
    wall.length -= first;
    return true;
  }
  return false;
}

}  // namespace

bool patch_edge::convex() const {
  return angle < std::numbers::pi * 179 / 180;
}

bool patch_edge::vertical() const {
  return std::abs(angle - std::numbers::pi / 2) < 1e-6;
}

expected<surface_patch> find_patch(const mesh_builder& mesh, surface_id surface) {
  surface_patch patch;
  patch.surface = surface;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f) && mesh.facet(f).surface == surface)
      patch.facets.push_back(f);
  if (patch.facets.empty())
    return fail(ec::empty_selection,
                "surface " + std::to_string(surface) +
                  " has no outer side: it lies between two regions, or is gone already",
                "Select surfaces of the outside");
  auto border = border_of(mesh, patch.facets, surface);
  if (!border)
    return fail(border.error());
  patch.border = std::move(*border);
  measure(mesh, patch);
  return patch;
}

std::vector<patch_wall> walls_of(const mesh_builder& mesh, const surface_patch& patch) {
  std::vector<patch_wall> walls;
  auto edges = patch.border;
  std::erase_if(edges, [](const patch_edge& e) { return e.convex() && !e.vertical(); });
  const double tolerance = 1e-6 * patch.mean_edge;
  // Edges come in the order of facets: a run may start in its middle, so go on until nothing joins.
  while (!edges.empty()) {
    const auto& first = edges.back();
    const vec3 a = mesh.position(first.a);
    const vec3 b = mesh.position(first.b);
    const vec3 along = normalized(b - a - dot(b - a, patch.normal) * patch.normal);
    patch_wall wall{a, along, cross(along, patch.normal), norm(b - a), first.outer, first.convex()};
    edges.pop_back();
    for (bool joined = true; joined;) {
      const auto taken = std::erase_if(edges, [&](const patch_edge& edge) {
        if (edge.convex() != wall.descends)
          return false;
        const vec3 p = mesh.position(edge.a);
        const vec3 q = mesh.position(edge.b);
        return extend(wall, p, q, normalized(cross(q - p, patch.normal)), tolerance);
      });
      joined = taken > 0;
    }
    walls.push_back(wall);
  }
  std::ranges::stable_sort(walls, std::ranges::greater{}, &patch_wall::length);
  return walls;
}

}  // namespace tedit
