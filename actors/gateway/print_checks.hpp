// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/gateway/client_actor.hpp"

namespace tedit::gateway {

/// The answer PrintChecked with the marks of those facets where something was found. Cost: O(facet
/// slots).
[[nodiscard]] bulk make_print_check(const actors::print_checked& made);

}  // namespace tedit::gateway
