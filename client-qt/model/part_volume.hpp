// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client/surface.hpp"

namespace tedit::desktop {

/// What a closed surface encloses, m^3. Cost: O(facets); 1 ms for 80 000.
[[nodiscard]] double enclosed_volume(const client::surface_model& surface);

}  // namespace tedit::desktop
