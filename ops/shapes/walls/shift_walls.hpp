// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>

#include "mesh/features/wall_shape.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What counts as round here. A vertex that is a little off the shape stays as far off.
inline constexpr fit_limits round_enough{3e-3, true, true};

/// Surfaces that move together, with their exact shapes before.
using wall_set = std::map<surface_id, wall_shape>;

/// The planes, round cylinders and cones behind the surfaces. Errors: `empty_selection` for a
/// surface without an outer side, `invalid_argument` naming one of another shape. Cost: O(facet
/// slots).
[[nodiscard]] expected<wall_set> fit_walls(const mesh_version& mesh,
                                           const std::vector<surface_id>& surfaces);

/// Are all of the surfaces planes? Errors: those of `find_patch`. Cost: O(surfaces x facet slots).
[[nodiscard]] expected<bool> all_flat(const mesh_builder& mesh,
                                      const std::vector<surface_id>& surfaces);

/// Moves the walls by `distance` (m, outward; negative: into the material), parallel to themselves,
/// by their own vertices: each goes to where it is `distance` off every wall of the set that it
/// lies on and still on every neighbour's exact shape (on its facets where it has another one),
/// which is trimmed or prolonged. What is more than the tets bear goes in small steps, and the mesh
/// around is mended between them. Ids of surfaces and regions stay, and so does what hangs on them.
/// Errors: `invalid_argument` naming surface and place: a neighbour that runs on flush, a
/// cylinder that would vanish, another part of the boundary that is in the way, a
/// mesh that leaves no room; `cancelled`. The builder is then half changed and to be thrown away.
/// Cost: O(steps x (facet slots + tets around)).
[[nodiscard]] expected<void> shift_walls(mesh_builder& mesh, const wall_set& walls, double distance,
                                         const execution& run);

/// What a version has of the shift, as material put on or taken off: mean over the area and
/// furthest from `distance` over the moved surfaces' vertices; for cylinders the change of the
/// radius, fitted anew. Cost: O(facet slots).
[[nodiscard]] std::vector<figure> measure_shift(const mesh_version& base, const mesh_version& after,
                                                const wall_set& walls, double distance);

}  // namespace tedit::ops
