// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/boolean/cavity.hpp"
#include "ops/boolean/corefine.hpp"

namespace tedit::ops {

/// Puts the results of several shares of a cavity together: what two of them have in common is
/// there once afterwards, as an interface with the triangles of the one that comes first. Both were
/// made with the same tool in rational numbers, so that it is bounded by the same points; where the
/// tool took one side alone the other has a free surface there. `sides` says what is beyond each
/// triangle. Errors: `mesher_failed` where they do not fit together. Cost: O(triangles log
/// triangles).
[[nodiscard]] expected<corefined> join_shares(const cavity& hollow, corefined cut);

}  // namespace tedit::ops
