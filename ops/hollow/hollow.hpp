// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

struct hollow_settings {
  double thickness = 0;       ///< m: of the walls that stay.
  double drain_diameter = 0;  ///< m: through the middle of each selected wall; 0: these are open.
};

/// Makes a shell of the part: what lies deeper below its walls than their thickness goes. Selected
/// walls are open or get a drain hole each; without any a closed void is left. What is thinner than
/// twice the thickness stays full. Errors: `invalid_argument` where nothing of the part is thick
/// enough, or it would fall into pieces; those of `isosurface` and of `services::boolean`.
[[nodiscard]] expected<edit_result> hollow(const version_ptr& mesh,
                                           const std::vector<surface_id>& picked,
                                           const hollow_settings& settings, context& ctx);

}  // namespace tedit::ops
