// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "ops/shapes/outlines/dxf_groups.hpp"
#include "ops/shapes/outlines/plane_curve.hpp"

namespace tedit::ops {

/// Curves end to end: an entity, or several joined.
struct plane_path {
  std::vector<plane_curve> curves;
  bool closed = false;   ///< Where it says so; its ends may lie together without.
  std::size_t line = 0;  ///< Of the file.

  [[nodiscard]] point2 start() const { return point_of(curves.front(), 0); }
  [[nodiscard]] point2 end() const { return point_of(curves.back(), 1); }
};

/// Is it a LINE, LWPOLYLINE, POLYLINE, CIRCLE, ARC, ELLIPSE or SPLINE?
[[nodiscard]] bool is_outline_entity(std::string_view kind);

/// The path of such an entity in the plane of the drawing; `more` are the vertices that follow a
/// POLYLINE. No curve where it has no length, as a line across the plane. Errors: `bad_input` with
/// line and remedy for numbers that make no curve, for what is tilted, for surfaces and for splines
/// without control points.
[[nodiscard]] expected<plane_path> path_of_entity(const dxf_item& item,
                                                  std::span<const dxf_item> more);

/// What maps an entity's own axes to the drawing's: nothing, or a mirror where it is seen from
/// below. Source: Autodesk, DXF Reference, Arbitrary Axis Algorithm. Errors: `bad_input` for what
/// is tilted.
[[nodiscard]] expected<affine> axes_of_entity(const dxf_item& item);

}  // namespace tedit::ops
