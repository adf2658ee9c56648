// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/execution.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// A plane through a mesh, cut into triangles: the cap of what one side of the plane leaves.
struct plane_section {
  /// A point of the section: at `a` times (1 - t) plus `b` times t; a field at the vertices is
  /// interpolated the same way. `a` is below `b`, so that tets that share an edge share the point.
  struct point {
    vertex_id a = 0;
    vertex_id b = 0;
    double t = 0;
  };
  std::vector<point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise seen from the normal.

  [[nodiscard]] vec3 position(const mesh_version& mesh, std::uint32_t i) const {
    const auto& p = points[i];
    return (1 - p.t) * mesh.position(p.a) + p.t * mesh.position(p.b);
  }
};

/// Cuts a version with the plane through `at` across `normal` (any length but zero). Vertices on
/// the plane count as above it, so that neighbouring tets agree; a tet that only touches the plane
/// gives nothing. Errors: `invalid_argument` for numbers that are no plane, `cancelled`.
/// Cost: O(vertices + tets), 0.1 us each, and O(cut tets).
[[nodiscard]] expected<plane_section> cut_by_plane(const mesh_version& mesh, const vec3& at,
                                                   const vec3& normal, const execution& run);

}  // namespace tedit
