// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/placement.hpp"

namespace tedit::ops {

/// Keeps what lies on one side of a plane: below is the side that `normal` points away from.
/// Errors: `empty_selection` where nothing or all of the part would go, those of
/// `services::boolean`.
[[nodiscard]] expected<edit_result> plane_cut(const version_ptr& mesh, vec3 at, vec3 normal,
                                              bool keep_below,
                                              const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
