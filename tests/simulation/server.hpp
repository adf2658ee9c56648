// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>

#include "actors/gateway/client_actor.hpp"
#include "actors/node/hub.hpp"
#include "actors/session/session.hpp"
#include "actors/supervisor/pool.hpp"
#include "tests/simulation/disks.hpp"
#include "tests/simulation/workers.hpp"

namespace tedit::simulation {

/// The state of an actor that is known to be stateful, from outside.
template <class State, class Actor>
State& state_of(const Actor& who) {
  auto* self = caf::actor_cast<caf::abstract_actor*>(who);
  if constexpr (std::is_same_v<Actor, caf::actor>)
    return dynamic_cast<caf::stateful_actor<State>&>(*self).state;
  else
    return dynamic_cast<std::remove_pointer_t<typename Actor::template stateful_pointer<State>>&>(
             *self)
      .state;
}

/// A server as `server::start` puts it together, in one thread and without sockets.
class simulated_server {
public:
  simulated_server(timeline& time, const std::filesystem::path& documents,
                   std::shared_ptr<document_record> record);
  simulated_server(const simulated_server&) = delete;
  simulated_server& operator=(const simulated_server&) = delete;
  ~simulated_server();  ///< As by kill -9.

  [[nodiscard]] caf::actor connect(std::shared_ptr<gateway::connection> from);

  bool step(milliseconds limit) { return stage_.step(limit); }
  void strike(std::size_t role, worker_fault fault, std::size_t which) {
    processes_[role % 3]->strike(fault, which);
  }
  /// A machine joins with a worker of this role.
  void join(std::size_t role);
  [[nodiscard]] simulated_disks& disks() { return *disks_; }

  [[nodiscard]] const std::map<std::string, session_actor>& sessions() const;

  /// Work, waiters and holds that should have ended when nobody wants anything any more.
  [[nodiscard]] std::vector<std::string> leftovers();

private:
  template <class Pool>
  void check_pool(const Pool& pool, const char* name, std::vector<std::string>& found);

  stage stage_;
  std::array<std::shared_ptr<simulated_processes>, 3> processes_;
  std::unique_ptr<simulated_disks> disks_;
  std::shared_ptr<page_cache> cache_;
  page_store_actor pages_;
  worker_set pools_;
  caf::actor cad_;
  hub_actor hub_;
  gateway::gateway_parts parts_;
  std::vector<caf::actor> clients_;
};

}  // namespace tedit::simulation
