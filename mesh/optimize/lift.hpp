// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/improve.hpp"
#include "mesh/optimize/worst_first.hpp"

namespace tedit {

/// What is lifted, and for how long.
struct lift_settings {
  double target = 0.35;       ///< Tets with q below this are mended, worst first.
  double insert_below = 0.2;  ///< Those still below this get a vertex on an edge.
  int sweeps = 8;             ///< At most so many rounds, fewer where nothing changes.
};

/// Lifts the worst tets of a work mesh with the moves. One that could not be helped is tried again
/// only when something around it has changed. Throws when the job is cancelled (`guarded`).
void lift_worst(work_mesh& mesh, worst_first& moves, const lift_settings& settings);

/// The local pass after an edit: the boundary stays as it is. Errors: `cancelled`,
/// `out_of_memory`. Cost: O(tets), and 8 bytes a slot of the mesh.
[[nodiscard]] expected<improve_report> improve_locally(mesh_builder& mesh, std::vector<tet_id> tets,
                                                       const improve_settings& settings,
                                                       const execution& run);

}  // namespace tedit
