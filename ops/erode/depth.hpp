// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/erode/removal.hpp"

namespace tedit::ops {

/// How flat surfaces go down: a small depth needs no cut.
enum class lowering { by_vertices, with_cuts };

/// Lowers each surface by `depth` (m), one after the other on the evolving mesh, then mends the
/// cuts. Each gets a new surface at its floor; below a rising neighbour the wall continues that
/// neighbour's surface where it is coplanar, else it gets one of its own. Errors: see `erode`;
/// `mesher_failed` where a surface would have to be cut and may not.
[[nodiscard]] expected<void> erode_depth(mesh_builder& mesh,
                                         const std::vector<surface_id>& surfaces, double depth,
                                         lowering how, context& ctx, erosion_sum& sum);

}  // namespace tedit::ops
