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
/// Nothing for what is none. Source: ISO 2306, tap drills of coarse pitches.
[[nodiscard]] std::optional<double> thread_core(const std::string& thread);
/// "none" and all threads known, for a choice.
[[nodiscard]] std::vector<std::string> threads();

/// Drills along `outward` from the outside, or the other way round where only there is material.
/// Errors: `invalid_parameter` for shapes that are none, those of `services::boolean`.
[[nodiscard]] expected<edit_result> drill(const version_ptr& mesh, const placement& where,
                                          const drill_shape& shape,
                                          const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
