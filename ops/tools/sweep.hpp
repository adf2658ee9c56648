// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/tools.hpp"

namespace tedit::ops {

/// A profile carried along a path of points (m), with triangles of about `size`: a bead, a groove,
/// a channel. It stands across the path and is mitred at the corners, so that with its centroid on
/// the path it takes its area times the path's length. From one edge of the path to the next it
/// turns no more than that; at the first, y is as near to `up` as can be, or any way across where
/// `up` is zero. A path whose last point is its first is closed, and what it is turned by on the
/// way round is shared out along it. The ends are named "`name` start" and "`name` end", a closed
/// one has none. Errors: `invalid_parameter` for fewer than two points, a corner that turns back,
/// or a bend too narrow for the profile, naming the point; `mesher_failed` where outlines cross.
/// Whether the path comes too near to itself elsewhere is for the boolean to say.
[[nodiscard]] expected<tool_surface> sweep(const std::vector<vec3>& path, const profile& what,
                                           vec3 up, double size, const std::string& name,
                                           services& host);

}  // namespace tedit::ops
