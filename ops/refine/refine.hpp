// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/adapt/size_field.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Makes the edges of tets at what was picked at most `size` long (m; 0: half of what they are in
/// the mean), and longer ones further off. Errors: `empty_selection`, `invalid_parameter` where no
/// edge is longer or too many tets would come out, with the size that leaves as many as are
/// allowed; `cancelled`. Cost: O(mesh + new tets).
[[nodiscard]] expected<edit_result> refine(const version_ptr& mesh, const mesh_pick& pick,
                                           double size, context& ctx);

}  // namespace tedit::ops
