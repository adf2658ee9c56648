// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/model/handle_pose.hpp"

namespace tedit::desktop {

/// A convex body between two outlines with as many points, m; a plane has no `top`, a tip one
/// point.
struct ghost_body {
  std::vector<vec3> bottom;
  std::vector<vec3> top;
  bool has_edges = false;  ///< Between the outlines, too: a prism's. A cylinder has none.
};

/// What a form's tool looks like before anything is computed: cylinders for diameters with a depth
/// or height, cones for those with an angle, the cone of a tip, prisms for profiles, a square for a
/// plane. Bodies of a turned tool are one below the other, none in another. Empty where the
/// description says no simple shape: docs/plugins.md, *Handles in the view*, has the rules. Cost:
/// microseconds.
[[nodiscard]] std::vector<ghost_body> ghost_of(const handle_plan& plan,
                                               const ops::parameters& values,
                                               const handle_pose& pose);

}  // namespace tedit::desktop
