// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/outlines/dxf_drawing.hpp"

namespace tedit::ops {

/// Closed outlines, each of curves end to end.
struct joined_outlines {
  std::vector<std::vector<plane_curve>> loops;  ///< In the drawing's order.
  plane_box box;
  std::size_t repeated = 0;  ///< Curves that were drawn twice and count once.
};

/// What is closed by itself, and all else joined at its ends where they lie within a ten thousandth
/// of the drawing's longer side. Errors: `bad_input` with the place in the drawing's unit for an
/// open end, for more than two ends that meet, for a drawing without an outline. Cost: O(n log n).
[[nodiscard]] expected<joined_outlines> join_outlines(const dxf_drawing& drawing);

/// "(10.2, 5) mm".
[[nodiscard]] std::string place_text(const dxf_drawing& drawing, point2 at);

/// Where an edge of the outlines meets one that it has no corner in common with, or turns back onto
/// itself. Cost: O(n log n) where edges are short beside the whole.
[[nodiscard]] std::optional<point2> first_crossing(
  const std::vector<std::vector<point2>>& outlines);

}  // namespace tedit::ops
