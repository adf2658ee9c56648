// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/features/rims.hpp"

namespace tedit {

struct completion_settings {
  bool exact = false;          ///< Take the selection as it is.
  bool include_entry = false;  ///< Also take countersinks and counterbores around the hole.
};

/// A selection whose rims are all convex: caps put on them close the hole.
struct completed_selection {
  std::vector<surface_id> surfaces;  ///< With those that were added, ascending.
  std::vector<surface_id> added;
  std::vector<surface_id> behind;  ///< Of these, what would be a void behind a cap.
  std::vector<shell> shells;
};

/// Extends a selection of hole walls over concave rims (a bottom, a drill-point cone) until every
/// rim is convex: the surfaces across are added when at least half of the rim is concave and they
/// lie within 1.1 rim radii of the rim's axis. Measured: walls alone are wrong for 76 of 208 real
/// holes. Errors: `mixed_rim` naming the rim, `empty_selection`. Cost: O(facet slots + hole).
[[nodiscard]] expected<completed_selection> complete_hole(const mesh_version& mesh,
                                                          const std::vector<surface_id>& surfaces,
                                                          const completion_settings& settings);

}  // namespace tedit
