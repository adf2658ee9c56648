// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "actors/interfaces.hpp"
#include "actors/observation.hpp"
#include "actors/supervisor/lifeline.hpp"

namespace tedit::actors {

/// What an observer's server side needs.
struct observing_parts {
  hub_actor hub;
  caf::actor pages;  ///< Has the pages of all that is told.
  std::string name;  ///< The certificate's.
  std::shared_ptr<lifeline> line;
};

/// Makes what a node with an observer's certificate talks to. It ends with the observer that was
/// named first, and cuts the line of one that is `most_unanswered` events behind or watches nothing
/// for half a minute.
[[nodiscard]] observation_actor make_observing(caf::actor_system& system, observing_parts parts);

}  // namespace tedit::actors
