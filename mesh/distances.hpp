// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/vec3.hpp"

namespace tedit {

/// The distance of two segments, m; either may be a point. Cost: O(1).
[[nodiscard]] double segments_apart(vec3 a, vec3 b, vec3 c, vec3 d);

/// The distance of a point from a triangle, m; that may be flat or a point. Cost: O(1).
[[nodiscard]] double point_to_triangle(vec3 p, vec3 a, vec3 b, vec3 c);

}  // namespace tedit
