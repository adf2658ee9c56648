// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/profiles.hpp"

namespace tedit::ops {

/// Cuts the profile that the parameters describe into the part, against the outward direction, to
/// `height` (m) below the place; 0: through the part's box. Errors: `empty_selection` without place
/// and wall, `invalid_parameter`, those of `services::boolean`.
[[nodiscard]] expected<edit_result> cut_pocket(const version_ptr& mesh, const selection& picked,
                                               const parameters& values, context& ctx);

}  // namespace tedit::ops
