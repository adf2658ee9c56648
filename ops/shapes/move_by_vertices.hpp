// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/walls/shift_walls.hpp"

namespace tedit::ops {

/// Moves walls of any shape as a whole by their own vertices (`shift_walls`) by `distance` (m,
/// outward; negative: into the material), with what was measured of it. Errors: those of
/// `fit_walls` and `shift_walls`. Cost: that of the latter.
[[nodiscard]] expected<edit_result> move_by_vertices(const version_ptr& mesh,
                                                     const std::vector<surface_id>& surfaces,
                                                     double distance, shift_patience patience,
                                                     const execution& run);

/// Should flat walls move by their vertices before they are cut? Where another wall that is not
/// flat begins at their borders, as planes cut its chords; unless what would go along
/// (`find_carried`) is larger than they are: who lowers the end between two large rounds does not
/// mean these. Cost: O(facet slots) for each wall around.
[[nodiscard]] bool move_better_by_vertices(const version_ptr& mesh,
                                           const std::vector<surface_id>& surfaces,
                                           double distance);

}  // namespace tedit::ops
