// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/pieces.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

struct erode_settings {
  double depth = 0;  ///< m; above 0 surfaces are lowered by it, else layers of tets are taken off.
  int layers = 0;
  piece_policy pieces = piece_policy::refuse;  ///< When the part falls apart.
};

/// Takes material off below the selected surfaces: element layers as the paper's section 4.2 has
/// them (repaired: README.md of this folder), or a metric depth. Errors: `empty_selection` when
/// nothing can be taken off, `invalid_parameter` without depth and layers, `invalid_argument` when
/// the depth is more than the wall (with the most that works), when the part would fall apart
/// (unless allowed) or the cut would leave the wall; `degenerate_tet`, `cancelled`. Cost:
/// O(boundary + cut), O(bodies touched).
[[nodiscard]] expected<edit_result> erode(const version_ptr& mesh,
                                          const std::vector<surface_id>& surfaces,
                                          const erode_settings& settings, context& ctx);

}  // namespace tedit::ops
