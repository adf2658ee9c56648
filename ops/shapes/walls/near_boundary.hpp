// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/box_tree.hpp"
#include "mesh/version.hpp"

namespace tedit::ops {

/// The part's boundary within a box, for many short rays.
class near_boundary {
public:
  /// Cost: O(facet slots).
  near_boundary(const mesh_version& mesh, const box& where);

  /// Where a ray passes through the boundary.
  struct crossing {
    double distance = 0;  ///< m.
    bool leaves = false;  ///< The material ends here; else it begins.
    facet_id facet = no_id;
  };

  /// Ascending; at most `reach` (m) away along the unit direction. Cost: O(log n + facets near).
  [[nodiscard]] std::vector<crossing> along(vec3 from, vec3 direction, double reach) const;

private:
  std::vector<box> collect(const box& where);
  [[nodiscard]] std::array<vec3, 3> corners(facet_id f) const;

  const mesh_version& mesh_;
  std::vector<facet_id> facets_;
  box_tree tree_;
};

}  // namespace tedit::ops
