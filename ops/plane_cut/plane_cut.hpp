// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/placement.hpp"

namespace tedit::ops {

/// What stays of a part that a plane cuts: what the normal points away from, the rest, or both as
/// bodies of their own.
enum class kept_side { below, above, both };

/// The part cut by the plane through `at` across `normal` (unit). Where both sides stay, each has
/// vertices and a cut of its own, and the loads of a surface that is cut lie on both. Errors:
/// `empty_selection` where the plane leaves the part as it is, or nothing of it; those of
/// `services::boolean`. Cost: that of a boolean for each side; with both O(part) besides.
[[nodiscard]] expected<edit_result> plane_cut(const version_ptr& mesh, vec3 at, vec3 normal,
                                              kept_side keep, const std::vector<surface_id>& picked,
                                              context& ctx);

}  // namespace tedit::ops
