// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/execution.hpp"
#include "mesh/builder.hpp"

namespace tedit {

struct improve_settings {
  double flip_below = 0.35;    ///< Tets with q below this are flipped and relocated.
  double insert_below = 0.20;  ///< Tets still below this get a vertex on an interior edge.
  double floor = 0.15;         ///< A step that makes worse tets must stay above this (or improve).
  int rings = 2;               ///< Rings of tets around the region that may change, too.
  int sweeps = 8;              ///< At most so many rounds.
};

struct improve_report {
  double min_before = 0;  ///< Worst q in the region (with rings) before and after.
  double min_after = 0;
  std::size_t flips = 0;
  std::size_t relocations = 0;
  std::size_t insertions = 0;
};

/// The worst-first local pass: flips (2-3, 3-2, 4-4) and relocation of interior vertices that raise
/// the minimum quality, then vertex insertion on interior edges. The boundary is not changed: no
/// boundary vertex moves, no facet changes; region interfaces stay as they are. Never lowers the
/// minimum. Deterministic. Measured reasons stand in docs/improve.md.
/// Errors: `cancelled`. Cost: O(region).
[[nodiscard]] expected<improve_report> improve(mesh_builder& mesh,
                                               const std::vector<tet_id>& region,
                                               const improve_settings& settings,
                                               const execution& run);

}  // namespace tedit
