// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/gateway/client_actor.hpp"

namespace tedit::gateway {

/// The answer VersionsCompared, with the difference at the boundary of the version after as far as
/// there is one: the arrays that are always sent and those that are watched. Cost: O(boundary) and
/// O(surfaces).
[[nodiscard]] bulk make_comparison(const actors::compared& made, const watched_quantities& watched);

}  // namespace tedit::gateway
