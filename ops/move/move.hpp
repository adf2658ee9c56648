// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Moves the holes or bosses that the surfaces belong to by a vector (m), or copies them. What
/// moves keeps its surfaces' ids; a copy's are new. Errors: those of `pick_features`,
/// `invalid_parameter` for a way of no length, of `fill_holes` or `remove_protrusion`, and of
/// `place_copies`. Cost: that of these.
[[nodiscard]] expected<edit_result> move_features(const version_ptr& mesh,
                                                  const std::vector<surface_id>& picked, vec3 by,
                                                  bool copy, context& ctx);

}  // namespace tedit::ops
