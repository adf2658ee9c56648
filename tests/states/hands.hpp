// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "actors/interfaces.hpp"
#include "actors/worker/job_thread.hpp"
#include "tests/simulation/server.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::actors {

/// Threads, and a modeling worker that knows one operation, in one: work waits until the test has
/// it done.
struct hands_state {
  std::deque<std::pair<job_task, caf::typed_response_promise<acknowledged>>> tasks;
  std::optional<error> refusal;  ///< Of the list of operations.
  int asked = 0;
  static inline const char* name = "hands";
};
using hands_actor = caf::stateful_actor<hands_state>;

inline caf::behavior make_hands(hands_actor* self, int /*number*/) {
  return {[=](catalog_atom) -> caf::result<shared_catalogue> {
            ++self->state.asked;
            if (self->state.refusal)
              return to_caf(*self->state.refusal);
            operation_catalogue all;
            all.operations.emplace_back().about.id = "deform";
            return shared_catalogue(std::move(all));
          },
          [=](const job_task& task) {
            auto promise = self->make_response_promise<acknowledged>();
            self->state.tasks.emplace_back(task, promise);
            return promise;
          },
          [](const doing& that) { that.what(); }};
}

class WithHands : public States {
protected:
  hands_state& hands() { return simulation::state_of<hands_state>(hands_); }

  /// Several threads: all are the same hands.
  [[nodiscard]] std::vector<job_thread_actor> threads_of(std::size_t count) const {
    return std::vector<job_thread_actor>(count, caf::actor_cast<job_thread_actor>(hands_));
  }

  /// The oldest piece of work is done.
  void work() {
    ASSERT_FALSE(hands().tasks.empty());
    within(hands_, [this] {
      auto [task, promise] = std::move(hands().tasks.front());
      hands().tasks.pop_front();
      task.run();
      promise.deliver(acknowledged{});
    });
  }

  caf::actor hands_ = stage_.system().spawn(make_hands, 0);
};

}  // namespace tedit::actors
