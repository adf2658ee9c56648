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

/// From where to where a tool goes along the frame's z axis, m; 0 is the place.
struct tool_span {
  double from = 0;
  double to = 0;
};

/// A pocket's: as deep as asked, through all there is where `depth` is 0, and out of the part.
/// `radius` (m): of the profile.
[[nodiscard]] tool_span pocket_span(const mesh_version& mesh, const placement& where, double depth,
                                    double radius);

/// A boss's. On a wall that is flat there the foot is flush with it, which the boolean makes exact;
/// on any other one it goes down to where the wall is lowest.
[[nodiscard]] tool_span boss_span(const mesh_version& mesh, const placement& where, double height,
                                  double radius);

}  // namespace tedit::ops
