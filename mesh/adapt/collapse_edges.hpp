// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/execution.hpp"
#include "mesh/adapt/adapt_mesh.hpp"
#include "mesh/adapt/size_field.hpp"

namespace tedit {

/// How long edges shall become, and where; lengths in m.
struct collapse_settings {
  mesh_pick pick;
  double size = 0;       ///< Edges shorter than this go, and none that is left is longer for it.
  double depth = 0;      ///< How far from what was picked vertices may go.
  double tolerance = 0;  ///< How far the boundary may be from where it was.
};

struct collapse_report {
  std::size_t vertices = 0;  ///< That went.
  double deviation = 0;      ///< m: the boundary is at most so far from where it was.
};

/// Contracts edges, the shortest first, until none can go: a vertex within a wall is drawn along
/// the wall, one on an edge between two walls along that edge, one in a corner stays. No wall goes
/// as a whole. Tets that come out have q of at least 0.2, or what the worst of those that went had.
/// Errors: `cancelled`. Cost: O(mesh), and some 200 us a vertex that goes.
[[nodiscard]] expected<collapse_report> collapse_edges(const mesh_version& base, adapt_mesh& mesh,
                                                       const collapse_settings& settings,
                                                       const execution& run);

}  // namespace tedit
