// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/gateway/client_actor.hpp"

namespace tedit::gateway {

/// Listens for clients and gives each its own actor. `options.accept`, `options.health` and
/// `parts.connections` are set here. Errors: those of `transport::start`.
[[nodiscard]] expected<std::unique_ptr<transport>> start_gateway(caf::actor_system& system,
                                                                 transport_options options,
                                                                 gateway_parts parts);

}  // namespace tedit::gateway
