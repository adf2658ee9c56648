// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/worker/worker_jobs.hpp"

namespace tedit::actors {

struct optimizer_state {
  worker_jobs jobs;

  static inline const char* name = "optimizer";
};

/// Improves and checks candidates, one after the other.
optimizer_actor::behavior_type make_optimizer(
  optimizer_actor::stateful_pointer<optimizer_state> self, std::shared_ptr<page_cache> cache,
  const page_store_actor& pages);

/// The job, without actors. A candidate that cannot even be opened is a failed postcondition.
[[nodiscard]] expected<job_output<check_result>> check(const check_order& order,
                                                       const job_input& in, const execution& run);

}  // namespace tedit::actors
