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

/// What the parameters of the operation ask for.
struct combine_order {
  tool_surface surface;  ///< Of the file, in its unit and its axes.
  combine_settings settings;
};

/// Errors: `invalid_parameter` without a file; those of `read_attachment` and of `read_surface`.
[[nodiscard]] expected<combine_order> combine_order_of(const parameters& values);

/// Where a file's surface comes to lie, m.
[[nodiscard]] std::vector<vec3> placed_points(const tool_surface& surface,
                                              const combine_settings& settings);

/// The surface (in the file's unit, `read_surface`) united with the part, cut from it, or what both
/// have in common. Errors: `empty_selection`, `invalid_argument` and the others of
/// `services::boolean`.
[[nodiscard]] expected<edit_result> combine(const version_ptr& mesh, tool_surface surface,
                                            const combine_settings& settings,
                                            const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
