// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/isosurface/isosurface.hpp"

namespace tedit::ops {

/// Puts points of triangles that pass through others into the middle of their cells, until none
/// does; has it? Cost: some rounds of O(n log n).
[[nodiscard]] bool untangle(contoured_surface& contour);

}  // namespace tedit::ops
