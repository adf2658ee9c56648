// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "mesh/vec3.hpp"

namespace tedit {

/// A box along the axes, empty at first; m.
struct box {
  vec3 low{1e300, 1e300, 1e300};
  vec3 high{-1e300, -1e300, -1e300};

  void add(vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }

  void add(const box& b) {
    low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
    high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
  }

  template <std::size_t N>
  void add(const std::array<vec3, N>& points) {
    for (const auto& p : points)
      add(p);
  }

  /// The box with `by` more on every side.
  [[nodiscard]] box grown(double by) const {
    const vec3 step{by, by, by};
    return {low - step, high + step};
  }

  /// Have they a point in common? Boxes that touch have.
  [[nodiscard]] bool meets(const box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
           low.z <= b.high.z && b.low.z <= high.z;
  }

  friend bool operator==(const box&, const box&) = default;
};

template <std::size_t N>
[[nodiscard]] box box_of(const std::array<vec3, N>& points) {
  box result;
  result.add(points);
  return result;
}

}  // namespace tedit
