// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "base/execution.hpp"
#include "mesh/builder.hpp"

namespace tedit {

struct tidy_settings {
  double target = 0.25;  ///< Tets with q below this are worked on.
  /// Curved surfaces may be left by this share of the longest edge around (`may_merge`); without
  /// it nothing mends points that a cut put close together on a round wall.
  double tolerance = 0.02;
  /// Instead of it, where given: the share for each surface; the least of a vertex' surfaces
  /// counts.
  std::function<double(surface_id)> tolerance_of;
  int rings = 1;   ///< Rings of tets around the region that may change, too.
  int sweeps = 6;  ///< At most so many rounds.
};

struct tidy_report {
  std::size_t collapses = 0;
  std::size_t relocations = 0;
  double min_before = 0;  ///< Worst q of the region (with rings) before and after.
  double min_after = 0;
};

/// Mends what a cut leaves behind, worst tet first: contracts edges and moves vertices wherever
/// that raises the worst quality around. Unlike `improve` it also works on the boundary, where a
/// vertex may go without changing the part's shape: in flat surfaces and along straight edges
/// (`vertex_freedom`), and merges vertices close together on curved ones; regions and interfaces
/// stay.
/// Deterministic. Errors: `cancelled`. Cost: O(region).
[[nodiscard]] expected<tidy_report> tidy_cut(mesh_builder& mesh, const std::vector<tet_id>& region,
                                             const tidy_settings& settings, const execution& run);

}  // namespace tedit
