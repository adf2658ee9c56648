// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

#include "mesh/box.hpp"

namespace tedit {

/// Places on a Morton (Z-order) curve through a cube: points that are near each other in space
/// mostly have codes that are near each other. 21 bits a coordinate.
/// Source: G. M. Morton, "A computer oriented geodetic data base" (IBM, 1966).
class morton_curve {
public:
  /// Through the smallest cube from the box's low corner that holds the box; m.
  explicit morton_curve(const box& extents)
      : low_(extents.low),
        cells_per_metre_(2097151.0 /
                         std::max({extents.high.x - extents.low.x, extents.high.y - extents.low.y,
                                   extents.high.z - extents.low.z, 1e-300})) {}

  /// Of a point inside the box.
  [[nodiscard]] std::uint64_t code(vec3 point) const {
    const vec3 cell = cells_per_metre_ * (point - low_);
    return spread(static_cast<std::uint64_t>(cell.x)) |
           spread(static_cast<std::uint64_t>(cell.y)) << 1 |
           spread(static_cast<std::uint64_t>(cell.z)) << 2;
  }

private:
  /// 21 bits to every third place.
  static std::uint64_t spread(std::uint64_t x) {
    x &= 0x1FFFFF;
    x = (x | x << 32) & 0x1F00000000FFFF;
    x = (x | x << 16) & 0x1F0000FF0000FF;
    x = (x | x << 8) & 0x100F00F00F00F00F;
    x = (x | x << 4) & 0x10C30C30C30C30C3;
    return (x | x << 2) & 0x1249249249249249;
  }

  vec3 low_;
  double cells_per_metre_;
};

}  // namespace tedit
