// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// A face of a tet: its local face, opposite to that corner.
struct tet_side {
  tet_id tet = no_id;
  int face = 0;
};

/// The corners of a side, in outward order.
[[nodiscard]] std::array<vertex_id, 3> corners_of(const mesh_version& mesh, tet_side side);

/// The sides that each surface consists of: its boundary facets in the order of their slots, then
/// its interface triangles, each from one of its two tets. Cost: O(facets); O(tets) where there are
/// interfaces.
[[nodiscard]] std::map<surface_id, std::vector<tet_side>> sides_of_surfaces(
  const mesh_version& mesh);

}  // namespace tedit
