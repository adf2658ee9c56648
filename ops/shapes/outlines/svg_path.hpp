// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "ops/shapes/outlines/plane.hpp"

namespace tedit::ops {

/// A piece of an outline: a cubic Bezier curve from the end of the one before; straight where both
/// control points are its ends.
struct curve_piece {
  point2 first;   ///< Control point.
  point2 second;  ///< Control point.
  point2 end;
  bool straight = false;
};

/// A closed outline of lines and curves.
struct curved_outline {
  point2 start{};
  std::vector<curve_piece> pieces;
};

/// The outlines of a path's `d` attribute, each taken for closed; a mistake, also a number that is
/// not finite, ends it, as the standard wants it. Source: SVG 1.1, 8.3, and F.6 for arcs. Cost:
/// O(text).
[[nodiscard]] std::vector<curved_outline> svg_path(std::string_view d);

}  // namespace tedit::ops
