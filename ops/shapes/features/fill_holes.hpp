// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/features/hole.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Fills the holes whose wall surfaces are given (paper, section 4.1; measured recipe: README.md of
/// this folder): completes the selection, caps every rim, meshes the plug, merges it over shared
/// vertices. Several holes at once are one edit. Each cap gets a surface of its own, or that of the
/// flat or second-order surface around it which it goes on. Errors: `mixed_rim`, `non_planar_rim`,
/// `not_a_hole`, `flat_plug`, `cap_intersects`, `mesher_failed`, `timeout`, `cancelled`. Cost:
/// O(boundary) for the gates, else O(plug).
[[nodiscard]] expected<edit_result> fill_holes(const version_ptr& mesh,
                                               const std::vector<surface_id>& surfaces,
                                               const completion_settings& settings, context& ctx);

}  // namespace tedit::ops
