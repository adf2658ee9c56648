// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "client/surface.hpp"

namespace tedit::desktop {

/// What a person pointed at as operations take it: "edge:3,7" where an edge of the wall is within
/// `reach` (m) of the point, "surface:3" elsewhere. Cost: O(facets).
[[nodiscard]] std::string pick_words(const client::surface_model& part, surface_id wall,
                                     const vec3& at, double reach);

}  // namespace tedit::desktop
