// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Raises flat surfaces by `height` (m): the space between a surface and its parallel is filled
/// like a plug and glued on. Where the border is convex the sides go straight up, where a neighbour
/// rises beside the surface it is covered up to the height. The raised surface keeps its id; sides
/// continue the neighbour's surface where they are coplanar with it, else they get one of their
/// own. Other surfaces move as a whole (`shift_walls`); what neither way can do is added as a tool
/// (`move_by_tool`). Errors: `invalid_argument` where there is no room or a wall bends too sharply,
/// `cap_intersects` where a slab would run into another part of the boundary, `not_a_hole` where it
/// does not close,
/// `mesher_failed`, `timeout`, `cancelled`. Cost: O(boundary + slab).
[[nodiscard]] expected<edit_result> thicken(const version_ptr& mesh,
                                            const std::vector<surface_id>& surfaces, double height,
                                            context& ctx);

}  // namespace tedit::ops
