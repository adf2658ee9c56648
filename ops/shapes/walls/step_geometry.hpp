// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "mesh/types.hpp"

namespace tedit::ops {

/// What a step is that goes along `way` (unit) from a rim beside a round surface whose axis has
/// that direction, too, as a fillet around a bore has: a cylinder. None beside another surface, and
/// where the rim's points lie on no one circle.
/// @param beside what the surface beside the step is (`find_geometry`).
/// @param rim points, m. Cost: O(points).
[[nodiscard]] surface_geometry step_geometry(const surface_geometry& beside,
                                             std::span<const vec3> rim, vec3 way);

}  // namespace tedit::ops
