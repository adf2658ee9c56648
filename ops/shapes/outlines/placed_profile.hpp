// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/outlines/outline_file.hpp"

namespace tedit::ops {

/// What is extruded from a wall or into it, and where.
struct placed_profile {
  placement where;
  frame place;                       ///< z is outward.
  profile shape;                     ///< In its x and y.
  double size = 0;                   ///< m: what the tool's triangles should measure.
  std::vector<std::string> notices;  ///< Of how a file was read.
};

/// `profiles_with_file` with the profile "points" and the parameter of that name.
[[nodiscard]] std::vector<parameter_description> placed_profile_parameters();

/// Of these parameters, "at" and "direction". `longest`: the most that `size` may be, m. Points are
/// places of the part: what is seen of them along the outward direction is the outline, around
/// their middle; where neither a wall nor a place is given, the middle is the place. Errors: those
/// of `placement_of`, `profile_from` and `outline_file`; `invalid_parameter` for points that are no
/// outline.
[[nodiscard]] expected<placed_profile> placed_profile_of(const mesh_version& mesh,
                                                         const selection& picked,
                                                         const parameters& values, double longest);

}  // namespace tedit::ops
