// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/worker/job_desk.hpp"

namespace tedit::actors {

struct optimizer_state {
  job_desk desk;

  static inline const char* name = "optimizer";
};

/// Improves and checks candidates, one after the other.
optimizer_actor::behavior_type make_optimizer(
  optimizer_actor::stateful_pointer<optimizer_state> self, std::shared_ptr<page_cache> cache,
  page_store_actor pages);

/// The job, without actors. A candidate that cannot even be opened is a failed postcondition.
[[nodiscard]] expected<job_output<finish_result>> finish(const finish_order& order,
                                                         const page_set& pages,
                                                         const execution& run);

}  // namespace tedit::actors
