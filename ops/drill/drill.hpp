// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/hole.hpp"
#include "ops/tools/several_places.hpp"

namespace tedit::ops {

/// What is drilled along `outward`, as `drill` does. Errors: `invalid_parameter` for shapes that
/// are none or too fine for the mesh there.
[[nodiscard]] expected<placed_tool> drill_tool(const mesh_version& mesh, const placement& where,
                                               const drill_shape& shape);

/// Drills along `outward` from the outside, or the other way round where only there is material.
/// Errors: `invalid_parameter` for shapes that are none, those of `services::boolean`.
[[nodiscard]] expected<edit_result> drill(const version_ptr& mesh, const placement& where,
                                          const drill_shape& shape,
                                          const std::vector<surface_id>& picked, context& ctx);

/// The same as the parameters of the operation ask for it, at each of their places or at none.
/// Errors: also `empty_selection` without place and wall, and those of `apply_tools`.
[[nodiscard]] expected<edit_result> drill_holes(const version_ptr& mesh, const selection& picked,
                                                const parameters& values, context& ctx);

}  // namespace tedit::ops
