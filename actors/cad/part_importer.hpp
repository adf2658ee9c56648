// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <list>
#include <memory>
#include <vector>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/interfaces.hpp"
#include "actors/worker/job_thread.hpp"

namespace tedit::actors {

struct part_importer_state {
  struct task {
    std::shared_ptr<const part_order> order;
    caf::typed_response_promise<part_document> promise;
  };

  part_importer_state() = default;
  part_importer_state(const part_importer_state&) = delete;
  part_importer_state& operator=(const part_importer_state&) = delete;
  ~part_importer_state();  ///< Its threads notice that nobody wants their work.

  std::chrono::seconds limit{};
  std::vector<job_thread_actor> free_threads;
  std::deque<task> waiting;
  std::list<cancel_token> running;
  bool looking = false;  ///< At those that wait, again and again.

  static inline const char* name = "part_importer";
};

/// @param threads one for each file at once; they end with the actor. `limit` is the time that each
/// of the programs which read and mesh one has, of CPU and by the clock.
part_importer_actor::behavior_type make_part_importer(
  part_importer_actor::stateful_pointer<part_importer_state> self,
  std::vector<job_thread_actor> threads, std::chrono::seconds limit);

}  // namespace tedit::actors
