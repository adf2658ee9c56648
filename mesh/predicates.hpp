// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "mesh/vec3.hpp"

namespace tedit {

/// Exact sign of det[b-a, c-a, d-a]: +1, 0 or -1 (CGAL, filtered). 0 where a coordinate is not
/// finite.
[[nodiscard]] int orient3d(vec3 a, vec3 b, vec3 c, vec3 d);

/// Exact: do the closed triangles share a point? Triangles that share corners or an edge do.
[[nodiscard]] bool triangles_intersect(const std::array<vec3, 3>& a, const std::array<vec3, 3>& b);

}  // namespace tedit
