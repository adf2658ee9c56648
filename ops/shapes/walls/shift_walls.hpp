// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/walls/carried_surfaces.hpp"

namespace tedit::ops {

/// How small the steps may become before the way counts as none.
enum class shift_patience {
  little,  ///< 1/32 of the way: where another way is left.
  all      ///< 1/128.
};

/// Moves the walls by `distance` (m, outward; negative: into the material), parallel to themselves,
/// by their own vertices: each goes to where it is `distance` off every wall of the set that it
/// lies on (along its normal there where the wall has no exact shape) and still on every
/// neighbour's exact shape (on its facets where it has another one), which is trimmed or prolonged.
/// What is more than the tets bear goes in small steps, and the mesh around is mended between them.
/// Ids of surfaces and regions stay, and so does what hangs on them. What went along
/// (`find_carried`) is returned. Errors: `invalid_argument`
/// naming surface and place: a neighbour that runs on flush, a cylinder that would vanish, another
/// part of the boundary that is in the way, a mesh that leaves no room; `cancelled`. The builder is
/// then half changed and to be thrown away. Cost: O(steps x (facet slots + tets around)).
[[nodiscard]] expected<carried_set> shift_walls(mesh_builder& mesh, const wall_set& walls,
                                                double distance, shift_patience patience,
                                                const execution& run);

}  // namespace tedit::ops
