// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <vector>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/interfaces.hpp"
#include "actors/worker/job_thread.hpp"
#include "base/execution.hpp"

namespace tedit::actors {

struct cad_editor_state {
  struct task {
    job_id job;
    std::shared_ptr<const cad_order> order;
    caf::typed_response_promise<cad_outcome> promise;
  };

  cad_editor_state() = default;
  cad_editor_state(const cad_editor_state&) = delete;
  cad_editor_state& operator=(const cad_editor_state&) = delete;
  ~cad_editor_state();  ///< Its threads notice that nobody wants their work.

  modeling_actor modeling;
  std::vector<job_thread_actor> free_threads;
  std::deque<task> waiting;
  std::map<job_id, cancel_token> running;
  /// What the workers offer; null until the first edit.
  std::shared_ptr<const operation_catalogue> operations;

  static inline const char* name = "cad_editor";
};

/// Makes edits on CAD models (cad/replay.hpp), as many at once as there are threads, each in a
/// process. @param modeling knows the operations; `threads` end with the actor.
cad_editor_actor::behavior_type make_cad_editor(
  cad_editor_actor::stateful_pointer<cad_editor_state> self, modeling_actor modeling,
  std::vector<job_thread_actor> threads);

/// A thread that gives way, with all processes that it starts, to all other work of the machine:
/// who edits a mesh does not notice. Unless TEDIT_CAD_PRIORITY is "normal": tests wait for it on
/// machines that are never idle.
[[nodiscard]] job_thread_actor spawn_background_thread(caf::actor_system& system);

}  // namespace tedit::actors
