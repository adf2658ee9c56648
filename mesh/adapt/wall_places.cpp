// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/wall_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace tedit {

namespace {

/// Of the edge: where walls meet under so small an angle that their common point is further away,
/// the middle is taken.
constexpr double furthest_share = 0.5;
/// Of an edge: nearer to a wall a vertex is on it.
constexpr double on_wall_share = 1e-4;

}  // namespace

const std::optional<exact_wall>& wall_places::wall_of(surface_id id) {
  const auto [row, fresh] = walls_.try_emplace(id);
  if (fresh)
    row->second = find_wall(id);
  if (fresh && row->second && !row->second->flat() && is_round_ && !is_round_(id))
    row->second.reset();
  return row->second;
}

std::optional<exact_wall> wall_places::find_wall(surface_id id) const {
  const auto facets = facets_of(mesh_, std::array{id});
  auto exact = find_exact(mesh_, facets);
  return exact ? exact : fit_free_form(corners_of(mesh_, facets), near_);
}

double wall_places::off(surface_id id, vec3 p) {
  const auto& w = wall_of(id);
  return w ? std::abs(w->distance(p)) : 0;
}

vec3 wall_places::middle(vec3 a, vec3 b, std::span<const surface_id> ids) {
  const vec3 start = 0.5 * (a + b);
  std::vector<wall_demand> demands;
  for (const auto id : ids) {
    const auto& w = wall_of(id);
    if (!w)
      continue;  // What it looks like between its corners nobody knows.
    // A plane is where the edge lies, not where the fit has it.
    demands.push_back(w->flat() ? wall_demand{nullptr, start, w->shape.axis, false}
                                : wall_demand{&*w, {}, {}, false});
  }
  if (std::ranges::none_of(demands, [](const wall_demand& d) { return d.wall != nullptr; }))
    return start;
  const auto place = place_on_walls(demands, start);
  return place.found && norm(place.at - start) <= furthest_share * norm(b - a) ? place.at : start;
}

std::size_t count_off_walls(const mesh_version& before, const mesh_version& after,
                            std::span<const tet_id> changed) {
  box near;
  for (const auto t : changed)
    near.add(after.corners(t));
  wall_places walls(before, {}, near);
  std::set<vertex_id> off;
  for (const auto t : changed)
    for (const auto n : after.neighbours(t)) {
      if (!is_facet(n))
        continue;
      const auto& facet = after.facet(n & ~facet_flag);
      const double edge = norm(after.position(facet.v[1]) - after.position(facet.v[0]));
      for (const auto v : facet.v)
        if (v >= before.vertex_slots() &&
            walls.off(facet.surface, after.position(v)) > on_wall_share * edge)
          off.insert(v);
    }
  return off.size();
}

}  // namespace tedit
