// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <caf/actor.hpp>
#include <caf/actor_system.hpp>

#include "actors/links/open_actors.hpp"
#include "base/error.hpp"
#include "base/execution.hpp"
#include "base/unique_fd.hpp"

/// Links between the nodes of one machine: CAF's protocol over a pair of connected sockets of which
/// a worker inherits one end. There is no port that a stranger could find, and what comes over a
/// link passes a `basp_guard` first.
/// The ways into CAF are its broker's own messages, semi-internal in 0.17.6; what is used of them
/// is held by tests/actors/link_test.cpp.
namespace tedit::actors {

/// Both ends of a new link; neither is inherited unless it is handed over by name.
struct link_ends {
  unique_fd ours;
  unique_fd theirs;
};

/// Errors: `io_error` with the system's reason.
[[nodiscard]] expected<link_ends> make_link();

/// Serves `end`: whoever joins at the other end is given `enlister` to talk to, and may beside it
/// send to the actors within `others`; a message to another one cuts the link. Returns at once.
void serve_link(caf::actor_system& system, unique_fd end, const caf::actor& enlister,
                reach others = reach_of({}));

/// Joins the link that is served at the other end and gives the enlister there.
/// Errors: `service_unavailable` when nobody answers within five seconds; `cancelled` by `stop`,
/// which is looked at five times a second.
[[nodiscard]] expected<caf::actor> join_link(caf::actor_system& system, unique_fd end,
                                             const cancel_token& stop = {});

}  // namespace tedit::actors
