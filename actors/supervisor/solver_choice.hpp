// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "actors/interfaces.hpp"

namespace tedit::actors {

/// Solvers of their own kind that a server takes in.
inline constexpr std::size_t most_own_devices = 16;

/// Whether a solver of its own kind may be called so: 1 to 63 letters, digits, ".", "-" and "_",
/// and not as devices that every server has.
[[nodiscard]] bool can_be_own_device(const std::string& name);

/// Stands for all solvers: orders for a device that a node of its own kind offers
/// (`node_facts::own_device`) go to the pool of those, all others to `common`. Case does not
/// matter. `make_pool` makes the pool for such a device when the first one joins; it stays, so that
/// who asks for the device later is told that nobody offers it now.
[[nodiscard]] solver_actor make_solver_choice(
  caf::actor_system& system, solver_actor common,
  std::function<solver_actor(caf::actor_system&, const std::string& device)> make_pool);

}  // namespace tedit::actors
