// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "ops/shapes/outlines/outline_file.hpp"
#include "ops/tools/several_places.hpp"

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

/// What of a profile's tool depends on whether it is a pocket or a boss.
struct profile_tool {
  boolean_mode mode = boolean_mode::cut;
  std::string name;    ///< Of its surfaces.
  double longest = 0;  ///< m: the most that the tool's triangles may measure.
  /// From where to where it goes; `radius` (m): of the profile.
  std::function<tool_span(const placed_profile& what, double radius)> span;
};

/// The profile of the parameters cut from the part or added to it, at each of their places. Errors:
/// those of `placed_profile_of`, `extrude` and `apply_tools`; `invalid_parameter` for places beside
/// an outline by its points, which is in one place.
[[nodiscard]] expected<edit_result> apply_profile(const version_ptr& mesh, const selection& picked,
                                                  const parameters& values, const profile_tool& how,
                                                  context& ctx);

}  // namespace tedit::ops
