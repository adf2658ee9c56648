// SPDX-License-Identifier: AGPL-3.0-or-later
// Workers of other machines: how a server takes them in.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <caf/actor_system.hpp>

#include "actors/interfaces.hpp"
#include "actors/supervisor/lifeline.hpp"
#include "actors/worker_roles.hpp"

namespace tedit::actors {

/// Who stands at the other end of a connection that has shown its certificate.
struct node_peer {
  std::string name;  ///< The certificate's.
  std::string address;
  worker_role role = worker_role::solver;  ///< The certificate's: it may be nothing else.
  std::shared_ptr<lifeline> line;
};

/// Whether programs of these versions understand each other: "1.4.2" and "1.5.0" do, so that the
/// machines of a network are brought up to date one by one; "1.4" and "1.6", or "1.9" and "2.0",
/// do not. False for what is no version.
[[nodiscard]] bool work_together(std::string_view a, std::string_view b);

/// Makes what the node talks to before it is a worker. It ends with the connection: `end_enlister`.
[[nodiscard]] caf::actor make_node_enlister(caf::actor_system& system, const worker_set& pools,
                                            node_peer peer, const std::string& version);
void end_enlister(const caf::actor& enlister);

}  // namespace tedit::actors
