// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/builder.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What became of tets that are flat within rounding.
struct flat_mending {
  std::size_t found = 0;
  std::size_t mended = 0;
};

/// Tets of the region whose corners lie in one plane within rounding, as meshers leave them, are
/// meshed anew with a ring or two of tets around (`services::tetrahedralise`): no local move
/// brings them to life where all their corners are on the boundary. Facets and what lies around
/// stay as they are. Where no filling is better, they stay. Errors: `cancelled`.
/// Cost: O(region); a process a place.
[[nodiscard]] expected<flat_mending> mend_flat_tets(mesh_builder& mesh,
                                                    const std::vector<tet_id>& region,
                                                    context& ctx);

}  // namespace tedit::ops
