// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Takes off the boss, rib or fin that the surfaces bound: completes the selection
/// (`complete_protrusion`), continues what it stands on under it, splits the tets there and removes
/// those above. Surfaces that the protrusion shares with the part are cut where it stood. The new
/// surface gets the id of the one around the foot, or its own. Errors: `not_a_protrusion`,
/// `empty_selection`, `invalid_argument` where the part would fall apart, `degenerate_tet`,
/// `cancelled`. Cost: O(protrusion), and a pass over the boundary.
[[nodiscard]] expected<edit_result> remove_protrusion(const version_ptr& mesh,
                                                      const std::vector<surface_id>& surfaces,
                                                      bool exact, context& ctx);

}  // namespace tedit::ops
