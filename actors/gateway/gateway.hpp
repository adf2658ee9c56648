// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/gateway/client_actor.hpp"

namespace tedit::gateway {

/// What GET /metrics answers: the numbers of this process (base/metrics.hpp), for whoever is on
/// this machine, and else for who knows the token: how much is done here, and when, is nobody
/// else's business.
[[nodiscard]] page_answer metrics_for(const page_request& asked, const gateway_parts& parts);

/// Listens for clients and gives each its own actor. `options.accept`, `options.pages` (/healthz,
/// /readyz, /metrics, /protocol.desc) and `parts.connections` are set here. Errors: those of
/// `transport::start`.
[[nodiscard]] expected<std::unique_ptr<transport>> start_gateway(caf::actor_system& system,
                                                                 transport_options options,
                                                                 gateway_parts parts);

}  // namespace tedit::gateway
