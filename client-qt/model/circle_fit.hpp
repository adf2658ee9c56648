// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/vec3.hpp"

namespace tedit::desktop {

struct plane_circle {
  std::array<double, 2> middle{};
  double radius = 0;
  double worst = 0;  ///< How far a point is off it at most.
};

/// The circle through points of a plane, by least squares; nothing where they are on a line.
/// Cost: O(points).
[[nodiscard]] std::optional<plane_circle> fit_circle(std::span<const std::array<double, 2>> points);

/// Two units across a unit: right-handed with it.
[[nodiscard]] std::array<vec3, 2> across(const vec3& z);

}  // namespace tedit::desktop
