// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/size_field.hpp"

#include <algorithm>

namespace tedit {

namespace {

std::vector<std::array<vec3, 3>> picked_triangles(const mesh_version& mesh, const mesh_pick& pick) {
  std::vector<std::array<vec3, 3>> result;
  if (pick.at)
    return result;
  for (const auto f : facets_of(mesh, pick.surfaces)) {
    const auto& v = mesh.facet(f).v;
    result.push_back({mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])});
  }
  return result;
}

/// The vertices of what was picked.
std::vector<vertex_id> picked_vertices(const mesh_version& mesh, const mesh_pick& pick) {
  std::vector<vertex_id> result;
  if (!pick.at) {
    for (const auto f : facets_of(mesh, pick.surfaces))
      result.insert(result.end(), mesh.facet(f).v.begin(), mesh.facet(f).v.end());
    return result;
  }
  vertex_id nearest = no_id;
  double least = 1e300;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.is_live_vertex(v))
      continue;
    const double d = norm(mesh.position(v) - *pick.at);
    if (d <= pick.radius)
      result.push_back(v);
    if (d < least)
      std::tie(least, nearest) = std::pair(d, v);
  }
  if (result.empty() && nearest != no_id)
    result.push_back(nearest);
  return result;
}

}  // namespace

pick_distance::pick_distance(const mesh_version& mesh, const mesh_pick& pick)
    : pick_(pick), facets_(picked_triangles(mesh, pick)) {}

double pick_distance::operator()(vec3 p, double at_most) const {
  if (pick_.at)
    return std::clamp(norm(p - *pick_.at) - pick_.radius, 0.0, at_most);
  return facets_(p, at_most);
}

std::vector<double> pick_distance::at_vertices(const mesh_version& mesh, double at_most) const {
  std::vector<double> result(mesh.vertex_slots(), at_most);
  vec3 last;
  double known = 1e300;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.is_live_vertex(v))
      continue;
    const vec3 p = mesh.position(v);
    // No further than by way of the vertex before.
    const double bound = std::min(at_most, (known + norm(p - last)) * (1 + 1e-9));
    result[v] = (*this)(p, bound);
    last = p;
    known = result[v] < at_most ? result[v] : 1e300;
  }
  return result;
}

double mean_size(const mesh_version& mesh, const mesh_pick& pick) {
  double sum = 0;
  std::size_t count = 0;
  for (const auto t : tets_around(mesh, picked_vertices(mesh, pick))) {
    const auto p = mesh.corners(t);
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j, ++count)
        sum += norm(p[i] - p[j]);
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace tedit
