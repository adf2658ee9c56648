// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/profiles.hpp"

namespace tedit::ops {

/// Puts the profile that the parameters describe on the part, to `height` (m) over the place, and
/// down to the wall wherever that is lower. Errors: `empty_selection` without place and wall,
/// `invalid_parameter`, those of `services::boolean`.
[[nodiscard]] expected<edit_result> add_boss(const version_ptr& mesh, const selection& picked,
                                             const parameters& values, context& ctx);

}  // namespace tedit::ops
