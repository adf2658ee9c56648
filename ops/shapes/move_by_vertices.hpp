// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Moves walls of any shape as a whole by their own vertices (`shift_walls`) by `distance` (m,
/// outward; negative: into the material), with what was measured of it. Errors: those of
/// `fit_walls` and `shift_walls`. Cost: that of the latter.
[[nodiscard]] expected<edit_result> move_by_vertices(const version_ptr& mesh,
                                                     const std::vector<surface_id>& surfaces,
                                                     double distance, const execution& run);

}  // namespace tedit::ops
