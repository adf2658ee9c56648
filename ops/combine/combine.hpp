// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Where a file's surface comes to lie, and how large it is.
struct combine_settings {
  boolean_mode mode = boolean_mode::add;
  double unit = 1e-3;       ///< m of one of the file's.
  double scale = 1;         ///< Besides.
  vec3 at;                  ///< m: where the file's origin comes to lie.
  vec3 direction{0, 0, 1};  ///< Unit: where its z axis points.
  double turn = 0;          ///< rad, about that.
};

/// The surface (in the file's unit, `read_surface`) united with the part, cut from it, or what both
/// have in common. Errors: `empty_selection`, `invalid_argument` and the others of
/// `services::boolean`.
[[nodiscard]] expected<edit_result> combine(const version_ptr& mesh, tool_surface surface,
                                            const combine_settings& settings,
                                            const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
