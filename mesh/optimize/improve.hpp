// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/execution.hpp"
#include "mesh/builder.hpp"
#include "mesh/optimize/improvement.hpp"

namespace tedit {

/// Errors: `invalid_parameter` for settings that are no numbers or out of range.
[[nodiscard]] expected<void> validate(const thorough_settings& settings);

/// Improves the tets of a region and its rings; never lowers their minimum quality. Without
/// `thorough` the worst-first local pass: flips (2-3, 3-2, 4-4, ...) and relocation of interior
/// vertices that raise the minimum, then vertex insertion on interior edges; no boundary vertex
/// moves, no facet changes. With it, passes that lift the worst (edge collapse, too) and passes
/// that lower the harmonic energy take turns, on all cores, and the boundary may change within the
/// tolerance. Region interfaces stay as they are in both. Deterministic, on any number of threads.
/// Measured reasons stand in docs/improve.md.
/// Errors: `cancelled`, `out_of_memory`. Cost: O(region), of the thorough pass O(mesh) once.
[[nodiscard]] expected<improve_report> improve(mesh_builder& mesh,
                                               const std::vector<tet_id>& region,
                                               const improve_settings& settings,
                                               const execution& run);

}  // namespace tedit
