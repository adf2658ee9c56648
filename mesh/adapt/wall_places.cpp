// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/wall_places.hpp"

#include <algorithm>
#include <cmath>

namespace tedit {

namespace {

/// Of the edge: where walls meet under so small an angle that their common point is further away,
/// the middle is taken.
constexpr double furthest_share = 0.5;
constexpr double apart_share = 1e-3;
constexpr int most_steps = 60;

}  // namespace

const std::optional<exact_wall>& wall_places::wall_of(surface_id id) {
  const auto [row, fresh] = walls_.try_emplace(id);
  if (fresh)
    row->second = fit_exact(corners_of(mesh_, facets_of(mesh_, std::array{id})));
  return row->second;
}

double wall_places::off(surface_id id, vec3 p) {
  const auto& w = wall_of(id);
  return w ? std::abs(w->distance(p)) : 0;
}

vec3 wall_places::middle(vec3 a, vec3 b, std::span<const surface_id> ids) {
  const vec3 start = 0.5 * (a + b);
  std::vector<const exact_wall*> walls;
  bool bent = false;
  for (const auto id : ids) {
    const auto& w = wall_of(id);
    if (!w)
      continue;  // What it looks like between its corners nobody knows.
    walls.push_back(&*w);
    bent = bent || !w->flat();
  }
  if (!bent)
    return start;
  const double size = norm(b - a);
  vec3 p = start;
  double moved = 0;
  // From wall to wall; a plane is where the edge lies, not where the fit has it.
  for (int step = 0; step < most_steps; ++step) {
    moved = 0;
    for (const auto* w : walls) {
      const double d = w->flat() ? dot(p - start, w->shape.axis) : w->distance(p);
      p = p - d * w->normal(p);
      moved = std::max(moved, std::abs(d));
    }
    if (!(norm(p - start) <= furthest_share * size))
      return start;
    if (moved <= 1e-13 * size)
      return p;
  }
  // Walls that touch without crossing, as far apart as their fits allow.
  return moved <= apart_share * size ? p : start;
}

}  // namespace tedit
