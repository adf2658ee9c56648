// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "mesh/features/wall_shape.hpp"

namespace tedit {

/// Brings a cylinder or cone that is near some points nearest to them: Gauss-Newton on the sum of
/// (distance from the axis - radius there)^2 over the axis' point and direction, the radius and,
/// for a cone, the slope. `size`: of the points' extent, for the scale of angles. Cost: O(points).
void refine_round_wall(std::span<const vec3> points, double size, wall_shape& shape);

}  // namespace tedit
