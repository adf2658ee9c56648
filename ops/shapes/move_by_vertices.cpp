// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/move_by_vertices.hpp"

#include "mesh/pieces.hpp"
#include "ops/shapes/walls/shift_walls.hpp"

namespace tedit::ops {

expected<edit_result> move_by_vertices(const version_ptr& mesh,
                                       const std::vector<surface_id>& surfaces, double distance,
                                       const execution& run) {
  const auto walls = fit_walls(*mesh, surfaces);
  if (!walls)
    return fail(walls.error());
  mesh_builder builder(mesh);
  if (auto ok = shift_walls(builder, *walls, distance, run); !ok)
    return fail(ok.error());
  edit_result result;
  result.candidate = builder.freeze();
  result.touched = builder.touched();
  result.volume_change = boundary_volume_change(*mesh, *result.candidate);
  result.surfaces_used = surfaces;
  // The host does not move the wall's vertices, so its worst tets stay as the shift left them.
  result.quality_floor = 0.1;
  result.figures = measure_shift(*mesh, *result.candidate, *walls, distance);
  return result;
}

}  // namespace tedit::ops
