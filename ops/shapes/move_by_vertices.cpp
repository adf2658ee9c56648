// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/move_by_vertices.hpp"

#include <algorithm>
#include <set>

#include "base/text.hpp"
#include "mesh/level_set_patch.hpp"
#include "mesh/pieces.hpp"

namespace tedit::ops {

namespace {

bool meet_curved_walls(const version_ptr& mesh, const std::vector<surface_id>& surfaces) {
  const mesh_builder as_is(mesh);
  std::set<surface_id> around;
  for (const auto id : surfaces)
    if (const auto patch = find_patch(as_is, id))
      for (const auto& edge : patch->border)
        around.insert(as_is.facet(edge.outer).surface);
  for (const auto id : surfaces)
    around.erase(id);
  return std::ranges::any_of(around, [&](surface_id id) {
    const auto patch = find_patch(as_is, id);
    return patch && !patch->flat();
  });
}

/// What goes along without having been selected.
std::vector<surface_id> others(const carried_set& along, const std::vector<surface_id>& surfaces) {
  std::vector<surface_id> result;
  for (const auto& [id, way] : along)
    if (!std::ranges::count(surfaces, id))
      result.push_back(id);
  return result;
}

double area_of(const mesh_version& mesh, const std::vector<surface_id>& surfaces) {
  double area = 0;
  for (const auto f : facets_of(mesh, surfaces))
    area += norm(area_vector(mesh, mesh.facet(f)));
  return area;
}

}  // namespace

expected<edit_result> move_by_vertices(const version_ptr& mesh,
                                       const std::vector<surface_id>& surfaces, double distance,
                                       shift_patience patience, const execution& run) {
  const auto walls = fit_walls(*mesh, surfaces);
  if (!walls)
    return fail(walls.error());
  mesh_builder builder(mesh);
  const auto along = shift_walls(builder, *walls, distance, patience, run);
  if (!along)
    return fail(along.error());
  edit_result result;
  result.candidate = builder.freeze();
  result.touched = builder.touched();
  result.volume_change = boundary_volume_change(*mesh, *result.candidate);
  result.surfaces_used = surfaces;
  // The host does not move the wall's vertices, so its worst tets stay as the shift left them.
  result.quality_floor = 0.1;
  result.figures = measure_shift(*mesh, *result.candidate, *walls, distance);
  if (const auto rounds = others(*along, surfaces); !rounds.empty())
    result.notices.push_back("rounds at the wall went along with it: surface " + list_of(rounds));
  return result;
}

bool move_better_by_vertices(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                             double distance) {
  if (!meet_curved_walls(mesh, surfaces))
    return false;
  auto walls = fit_walls(*mesh, surfaces);
  if (!walls)
    return false;
  const auto along = others(find_carried(*mesh, *walls, distance), surfaces);
  return area_of(*mesh, along) <= area_of(*mesh, surfaces);
}

}  // namespace tedit::ops
