// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/features/round_fit.hpp"

namespace tedit {

/// Which way a wall of free form looks at each of its corners: unit, outward.
struct corner_directions {
  std::vector<std::optional<vec3>> said;  ///< By the corners around.
  std::vector<vec3> mean;                 ///< Of the facets there, by their areas.
};

/// Fits the height over the tangent plane, a polynomial of third order, of second where corners are
/// few, to the corners within two edges of each. Nothing is said where that leaves a quarter of
/// what a plane does (creases, noise), where facets turn by more than 35 degrees from their mean,
/// and where the wall is less than four rows of corners wide: three lie on a parabola whatever they
/// are a part of. Cost: O(facets log facets), and some microseconds a corner.
[[nodiscard]] corner_directions directions_at_corners(const facet_corners& facets);

}  // namespace tedit
