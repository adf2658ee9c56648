// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/features/wall_shape.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// A round cylinder of a part: a bore, or a pin where the material is inside.
struct round_wall {
  wall_shape shape;
  std::vector<surface_id> surfaces;  ///< All that lie on it and hang together, ascending.
};

/// The cylinder that one surface lies on, with the other parts of it: a bore is often two halves.
/// Errors: `invalid_argument` where it is no round cylinder. Cost: O(facet slots) for each part.
[[nodiscard]] expected<round_wall> round_wall_of(const mesh_version& mesh, surface_id picked);

/// Gives bores (or pins) that the surfaces belong to another diameter, m. Their walls keep their
/// ids. Errors: `invalid_parameter` where one has it already; else as for `erode` and `thicken`,
/// with the diameter that can be. Cost: that of these.
[[nodiscard]] expected<edit_result> resize_bores(const version_ptr& mesh,
                                                 const std::vector<surface_id>& picked,
                                                 double diameter, context& ctx);

}  // namespace tedit::ops
