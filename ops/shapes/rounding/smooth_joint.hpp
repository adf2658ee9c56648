// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "ops/shapes/rounding/rolling_ball.hpp"

namespace tedit::ops {

/// Of the radius: by so much the arcs of two chains may differ where they meet.
inline constexpr double arcs_match = 5e-3;

/// A ball that rolls along a wall which two edges share, and along one that ends at their corner.
struct joint_end {
  const rolling_ball& ball;
  bool outer_is_b = true;  ///< Which of its walls ends there.

  [[nodiscard]] const exact_wall& outer() const { return outer_is_b ? ball.b() : ball.a(); }
};

/// Two edges go on in each other at `corner`, as their outer walls run on in each other: the ball
/// goes from the one to the other where it touches the line between these, which may lie askew to
/// the edges. Its centre there, by each of both; nothing where the walls are one, or the ball does
/// not come to that line. Cost: O(1).
[[nodiscard]] std::optional<std::array<vec3, 2>> centres_at_joint(
  const std::array<joint_end, 2>& ends, vec3 corner);

}  // namespace tedit::ops
