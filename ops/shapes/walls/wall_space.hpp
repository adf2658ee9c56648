// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/version.hpp"

namespace tedit::ops {

/// Is there nothing of the part that faces the surfaces where they shall go: the other side of a
/// wall that is too thin, or of a gap that is too narrow? What moves, too, comes as far to meet
/// them. Seen from the middles of their facets. Errors: `invalid_argument` with the least thickness
/// or gap that there is, whatever was asked for, between which surfaces, and where.
/// @param distance m, outward; negative: into the material. Cost: O(facet slots + surfaces).
[[nodiscard]] expected<void> check_space(const mesh_version& mesh,
                                         const std::vector<surface_id>& surfaces, double distance);

}  // namespace tedit::ops
