// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/vec3.hpp"

namespace tedit {

/// A tet whose volume (m^3) is lost in the rounding of its coordinates: it cannot carry a
/// stiffness. Cost: O(1).
[[nodiscard]] inline bool is_flat(const std::array<vec3, 4>& c, double volume) {
  double longest2 = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      longest2 = std::max(longest2, dot(c[i] - c[j], c[i] - c[j]));
  return std::abs(volume) <= 1e-10 * longest2 * std::sqrt(longest2);
}

}  // namespace tedit
