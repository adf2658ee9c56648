// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/hole.hpp"

namespace tedit::ops {

/// Drills along `outward` from the outside, or the other way round where only there is material.
/// Errors: `invalid_parameter` for shapes that are none, those of `services::boolean`.
[[nodiscard]] expected<edit_result> drill(const version_ptr& mesh, const placement& where,
                                          const drill_shape& shape,
                                          const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
