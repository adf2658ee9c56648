// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/segment/facet_net.hpp"
#include "mesh/segment/fitted_shape.hpp"

namespace tedit {

/// A surface in patches, each a part of a plane, cylinder, cone or sphere, or of free form.
struct segmentation {
  std::vector<std::uint32_t> patch_of;  ///< Of each triangle.
  std::vector<fitted_shape> shapes;     ///< Of each patch, in the order of their first triangles.
};

/// What a segmentation goes by, in the unit of the points.
struct segment_limits {
  double tolerance = 0;  ///< How far points may be off their plane: rounding of the file.
};

/// About as far as the coordinates of a surface file are rounded: two millionths of its extent.
[[nodiscard]] segment_limits limits_for(const triangle_surface& surface);

/// Divides a surface into patches. Facets that lie on one cylinder, cone or sphere are one patch,
/// however wide they are (up to 50 degrees on a circle, if they are about as wide as each other);
/// what is flat is a plane; the rest goes over edges that bend by less than 40 degrees. `groups`: a
/// number for each triangle that no patch may cross; empty: there are none. Deterministic. Cost:
/// O(n log n), more for what is round and free.
[[nodiscard]] segmentation segment_surface(const triangle_surface& surface,
                                           const segment_limits& limits,
                                           const std::vector<std::uint32_t>& groups = {});

/// "plane 1", "cylinder 3 d 8 mm", "free form 4": of a surface with this id. `unit_mm`: mm for each
/// unit of the shape.
[[nodiscard]] std::string name_of(const fitted_shape& shape, surface_id id, double unit_mm);

}  // namespace tedit
