// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <caf/actor_system_config.hpp>

namespace tedit::actors {

/// CAF's configuration for every node: the message types of `messages.hpp`, and heartbeats so that
/// a frozen node is noticed. Nothing is read from files or the command line.
class system_config : public caf::actor_system_config {
public:
  /// `networked`: the node talks to others.
  explicit system_config(bool networked);
};

}  // namespace tedit::actors
