// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/placement.hpp"

namespace tedit::ops {

/// The parameters `profile` (circle, rectangle, slot, polygon), `size`, `width` and `corners`, and
/// `along`: which way x goes on the wall.
[[nodiscard]] std::vector<parameter_description> profile_parameters();

/// What was asked for, on triangles of about `size`. Errors: `invalid_parameter` for a slot that is
/// wider than long.
[[nodiscard]] expected<profile> profile_from(const parameters& values, double size);

/// Half of its greatest extent, m.
[[nodiscard]] double radius_of(const profile& p);

/// The frame of a profile at a place: z is outward, x along the direction `along` if given.
[[nodiscard]] frame profile_frame(const placement& where, const parameters& values);

/// The mean edge that a profile wants: what the part has, less for small ones.
[[nodiscard]] double profile_size(const placement& where, const parameters& values);

}  // namespace tedit::ops
