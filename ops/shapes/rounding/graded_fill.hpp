// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Adds interior points to a constrained Delaunay triangulation of a polygon so that its triangles
/// grow from the length of the loops' edges nearby: fine beside fine edges, coarse beside coarse
/// ones. The loops stay. Circumcentres are inserted where a triangle is too large or too thin
/// (Ruppert 1995, without touching the boundary), then drawn to the mean of their neighbours.
/// Cost: O(n log n) in the points that come out.
[[nodiscard]] planar_filling graded_fill(const planar_polygon& polygon, planar_filling filling);

}  // namespace tedit::ops
