// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/wall_places.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/features/exact_wall.hpp"

namespace tedit {

namespace {

/// Corners may be so far off a sphere, as a share of its radius.
constexpr double roundness = 1e-4;

/// Of the edge: where walls meet under so small an angle that their common point is further away,
/// the middle is taken.
constexpr double furthest_share = 0.5;
constexpr double apart_share = 1e-3;
constexpr int most_steps = 60;

std::vector<vec3> points_of(const mesh_version& mesh, std::span<const facet_id> facets) {
  std::vector<vertex_id> ids;
  for (const auto f : facets)
    ids.insert(ids.end(), mesh.facet(f).v.begin(), mesh.facet(f).v.end());
  std::ranges::sort(ids);
  ids.erase(std::ranges::unique(ids).begin(), ids.end());
  std::vector<vec3> result;
  for (const auto v : ids)
    result.push_back(mesh.position(v));
  return result;
}

}  // namespace

double wall_places::wall::distance(vec3 p) const {
  return sphere_radius > 0 ? norm(p - shape->point) - sphere_radius : shape->distance(p);
}

vec3 wall_places::wall::normal(vec3 p) const {
  return sphere_radius > 0 ? normalized(p - shape->point) : shape->normal(p);
}

wall_places::wall wall_places::fitted(const mesh_version& mesh, surface_id id) {
  wall result;
  const auto facets = facets_of(mesh, std::array{id});
  result.shape = fit_wall(mesh, facets, {roundness, true, true});
  if (result.shape)
    return result;
  if (const auto sphere = fit_ball(points_of(mesh, facets), roundness)) {
    result.shape.emplace();
    result.shape->point = sphere->centre;
    result.sphere_radius = sphere->radius;
  }
  return result;
}

const wall_places::wall& wall_places::wall_of(surface_id id) {
  const auto found = walls_.find(id);
  return found != walls_.end() ? found->second
                               : walls_.emplace(id, fitted(mesh_, id)).first->second;
}

double wall_places::off(surface_id id, vec3 p) {
  const auto& w = wall_of(id);
  return w.known() ? std::abs(w.distance(p)) : 0;
}

vec3 wall_places::middle(vec3 a, vec3 b, std::span<const surface_id> ids) {
  const vec3 start = 0.5 * (a + b);
  std::vector<const wall*> walls;
  bool bent = false;
  for (const auto id : ids) {
    const auto& w = wall_of(id);
    if (!w.known())
      continue;  // What it looks like between its corners nobody knows.
    walls.push_back(&w);
    bent = bent || !w.flat();
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
      const double d = w->flat() ? dot(p - start, w->shape->axis) : w->distance(p);
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
