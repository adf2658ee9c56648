// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/local_size.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mesh/changes.hpp"
#include "mesh/distances.hpp"
#include "mesh/quality.hpp"

namespace tedit::ops {

namespace {

std::array<vec3, 3> corners_of(const mesh_version& mesh, facet_id f) {
  const auto& v = mesh.facet(f).v;
  return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

double mean_edge(const mesh_version& mesh, const box* where) {
  double sum = 0;
  std::size_t count = 0;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto p = corners_of(mesh, f);
    if (where && !where->meets(box_of(p)))
      continue;
    sum += norm(p[1] - p[0]) + norm(p[2] - p[1]) + norm(p[0] - p[2]);
    count += 3;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// The facet that is nearest to a point, among those that `counts` takes.
template <class Counts>
facet_id nearest_facet(const mesh_version& mesh, vec3 point, const Counts& counts) {
  facet_id best = no_id;
  double least = 1e300;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) || !counts(mesh.facet(f)))
      continue;
    const auto p = corners_of(mesh, f);
    const double distance = point_to_triangle(point, p[0], p[1], p[2]);
    if (distance < least) {
      least = distance;
      best = f;
    }
  }
  return best;
}

/// The point of a triangle nearest to p, by the foot in its plane drawn inside where it is outside.
vec3 nearest_point(const std::array<vec3, 3>& t, vec3 p) {
  const vec3 n = normalized(area_vector(t[0], t[1], t[2]));
  const vec3 foot = p - dot(p - t[0], n) * n;
  const double whole = dot(cross(t[1] - t[0], t[2] - t[0]), n);
  std::array<double, 3> share{};
  for (int k = 0; k < 3; ++k) {
    const vec3 a = t[(k + 1) % 3];
    const vec3 b = t[(k + 2) % 3];
    share[k] = std::max(0.0, dot(cross(b - a, foot - a), n) / whole);
  }
  const double sum = share[0] + share[1] + share[2];
  return (share[0] * t[0] + share[1] * t[1] + share[2] * t[2]) / sum;
}

}  // namespace

double local_size(const mesh_version& mesh, const box& where) {
  const double here = mean_edge(mesh, &where);
  return here > 0 ? here : mean_edge(mesh, nullptr);
}

double local_size(const mesh_version& mesh, const tool_surface& tool) {
  return local_size(mesh, extent_of(tool));
}

double enclosed_volume(const std::vector<vec3>& points,
                       const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  double sum = 0;
  for (const auto& t : triangles) {
    const vec3 origin = points.front();
    sum += dot(points[t[0]] - origin, cross(points[t[1]] - origin, points[t[2]] - origin));
  }
  return sum / 6;
}

box extent_of(const mesh_version& mesh) {
  box extent;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.is_live_vertex(v))
      extent.add(mesh.position(v));
  return extent;
}

box extent_of(const tool_surface& tool) {
  box extent;
  for (const auto& p : tool.points)
    extent.add(p);
  return extent;
}

std::vector<tet_id> changed_tets(const mesh_version& before, const mesh_version& after) {
  std::vector<tet_id> result;
  for_each_dirty_slot(before.data().tets, after.data().tets, [&](tet_id t) {
    if (t >= after.tet_slots() || !after.is_live_tet(t))
      return;
    const auto same_corners = [&] {
      return std::ranges::all_of(after.tet_at(t).v, [&](vertex_id v) {
        return v < before.vertex_slots() && before.position(v) == after.position(v);
      });
    };
    if (t >= before.tet_slots() || !(before.tet_at(t) == after.tet_at(t)) || !same_corners())
      result.push_back(t);
  });
  // Improvement moves vertices of tets that stay, too, whose own pages are as they were.
  std::vector<vertex_id> moved;
  for_each_dirty_slot(before.data().positions, after.data().positions, [&](vertex_id v) {
    if (v < before.vertex_slots() && v < after.vertex_slots() && before.is_live_vertex(v) &&
        after.is_live_vertex(v) && before.position(v) != after.position(v))
      moved.push_back(v);
  });
  std::ranges::copy(tets_around(after, moved), std::back_inserter(result));
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

double worst_quality(const mesh_version& mesh, const std::vector<tet_id>& tets) {
  double worst = 1;
  for (const auto t : tets)
    worst = std::min(worst, radius_ratio(mesh.corners(t)));
  return worst;
}

std::vector<ray_hit> ray_hits(const mesh_version& mesh, vec3 origin, vec3 direction) {
  std::vector<ray_hit> hits;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    if (const auto hit = ray_through(corners_of(mesh, f), origin, direction))
      hits.push_back({hit->distance, f, hit->leaves});
  }
  std::ranges::sort(hits, {}, &ray_hit::distance);
  return hits;
}

expected<wall_middle> middle_of(const mesh_version& mesh, surface_id surface) {
  vec3 sum;
  double area = 0;
  for (const auto f : facets_of(mesh, std::array{surface})) {
    const auto p = corners_of(mesh, f);
    const double share = norm(area_vector(mesh, mesh.facet(f)));
    sum += share * (p[0] + p[1] + p[2]) / 3;
    area += share;
  }
  if (area == 0)
    return fail(ec::surface_not_found,
                "surface " + std::to_string(surface) + " has no facet on the part's boundary",
                "Select a wall of the part");
  const vec3 centre = sum / area;
  const auto nearest = nearest_facet(
    mesh, centre, [&](const boundary_facet& facet) { return facet.surface == surface; });
  return wall_middle{nearest_point(corners_of(mesh, nearest), centre),
                     normalized(area_vector(mesh, mesh.facet(nearest)))};
}

vec3 outward_at(const mesh_version& mesh, vec3 point, const std::vector<surface_id>& surfaces) {
  const auto nearest = nearest_facet(mesh, point, [&](const boundary_facet& facet) {
    return surfaces.empty() || std::ranges::find(surfaces, facet.surface) != surfaces.end();
  });
  return nearest == no_id ? vec3{0, 0, 1} : normalized(area_vector(mesh, mesh.facet(nearest)));
}

}  // namespace tedit::ops
