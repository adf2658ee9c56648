// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <unordered_set>

#include "ops/shapes/rounding/round_strips.hpp"

namespace tedit::ops {

/// The tets that come nearer than `margin` (m) to where the part changes, found over faces from the
/// chains' vertices, and all tets at the vertices of `whole`. Errors: `invalid_argument` when two
/// regions lie there. Cost: O((found + reach) x log reach), more where large
/// tets lie near a long reach.
[[nodiscard]] expected<std::unordered_set<tet_id>> find_cavity(const mesh_version& mesh,
                                                               const round_plan& plan,
                                                               const round_surface& made,
                                                               const std::vector<vertex_id>& whole,
                                                               double margin);

/// Distance between a segment and a tet, m; 0 where they meet.
[[nodiscard]] double segment_to_tet(vec3 a, vec3 b, const std::array<vec3, 4>& corners);

}  // namespace tedit::ops
