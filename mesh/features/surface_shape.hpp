// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// A joint between two surfaces.
struct surface_joint {
  double length = 0;  ///< m.
  double angle = 0;   ///< Mean material angle over the length, rad; see `material_angle`.
};

/// A surface as a whole.
struct surface_shape {
  std::vector<facet_id> facets;
  double area = 0;     ///< m^2.
  double turning = 0;  ///< Mean of (material angle - pi) over its inner edges, rad: > 0 is concave.
  std::map<surface_id, surface_joint> joints;

  /// Bent inwards like the wall of a bore or a fillet: by more than half a degree an edge.
  [[nodiscard]] bool concave() const;
};

/// Cost: O(facet slots + the surface's facets).
[[nodiscard]] surface_shape shape_of(const mesh_version& mesh, surface_id id);

}  // namespace tedit
