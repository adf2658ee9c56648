// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/placement.hpp"

namespace tedit::ops {

/// A hole as drills make it; lengths in m, 0: without that.
struct drill_shape {
  double diameter = 0;
  double depth = 0;      ///< Of the cylinder, from the place on; 0: through all there is.
  double tip_angle = 0;  ///< rad, of the whole tip of a blind hole; 0: flat.
  double counterbore_diameter = 0;
  double counterbore_depth = 0;
  double countersink_diameter = 0;
  double countersink_angle = 0;  ///< rad, of the whole cone.
};

/// The core diameter (m) of an ISO metric coarse thread, "M6": what is drilled before it is cut.
/// Nothing for what is none.
[[nodiscard]] std::optional<double> thread_core(const std::string& thread);
/// "none" and all threads known, for a choice.
[[nodiscard]] std::vector<std::string> threads();

/// The shape that these parameters of `drill` ask for.
[[nodiscard]] drill_shape drill_shape_from(const parameters& values);

/// What a drill takes off, exactly: a half-section that is turned about the frame's z axis, which
/// points out of the material.
struct drilled_hole {
  frame place;
  std::vector<section_point> section;
  double length = 0;  ///< m: from end to end.
};

/// The hole along `outward` from the outside, or the other way round where only there is material.
/// Errors: `invalid_parameter` for shapes that are none. Cost: some rays.
[[nodiscard]] expected<drilled_hole> drilled_hole_of(const mesh_version& mesh,
                                                     const placement& where,
                                                     const drill_shape& shape);

}  // namespace tedit::ops
