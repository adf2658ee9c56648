// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/box_tree.hpp"
#include "mesh/features/wall_shape.hpp"

namespace tedit::ops {

/// A surface of any shape: its facets as they were before the edit. Beyond its border the plane of
/// the nearest one goes on.
class facet_sheet {
public:
  facet_sheet(const mesh_version& mesh, surface_id id);

  /// The plane through the point nearest to p, of the facets there on average. Cost: O(log facets)
  /// for a point near the surface.
  [[nodiscard]] wall_shape plane_at(vec3 p) const;

private:
  [[nodiscard]] double least_distance(vec3 p) const;
  template <class Visit>
  void visit_within(vec3 p, double reach, const Visit& visit) const;

  std::vector<std::array<vec3, 3>> triangles_;
  box_tree tree_;
  double size_ = 0;  ///< Longest edge of the first facet, m: points nearer than 1e-6 of it are one.
};

}  // namespace tedit::ops
