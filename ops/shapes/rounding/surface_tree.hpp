// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/box_tree.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// How a point lies to a closed surface, answered from the triangles near it.
class surface_tree {
public:
  /// The surface must outlive the tree. Cost: O(triangles log triangles).
  explicit surface_tree(const closed_surface& surface);

  /// Does any triangle come nearer to the point than `distance` (m)? Cost: O(log triangles +
  /// triangles about as near).
  [[nodiscard]] bool comes_within(vec3 p, double distance) const;

  /// How often the surface goes round a point that is not on it: 1 inside, 0 outside. Exact: how
  /// often a ray from the point goes out, less how often it comes in. The ray runs along the axis
  /// nearest to `along`; each gives the same. Cost: O(log triangles + triangles beside the ray): it
  /// should not run along a strip of many.
  [[nodiscard]] int winding(vec3 p, vec3 along) const;

private:
  [[nodiscard]] std::array<vec3, 3> corners(std::size_t triangle) const;

  const closed_surface& surface_;
  box_tree boxes_;
};

}  // namespace tedit::ops
