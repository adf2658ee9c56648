// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/caps/caps.hpp"

namespace tedit::ops {

/// What must hold before a plug is meshed (they keep the mesher from crashing: 134 of 3,332
/// arbitrary selections did, 2 with these gates): the surface is closed and oriented, encloses a
/// positive and not flat volume, caps cut neither the part nor each other, and lie outside the
/// material: at every rim edge they leave into the open side, and they cross the boundary nowhere.
/// Errors: `not_a_hole`, `flat_plug`, `cap_intersects`. Cost: O(boundary).
[[nodiscard]] expected<void> check_plug(const mesh_version& mesh, const shell& part,
                                        const plug_surface& plug);

}  // namespace tedit::ops
