// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/worker/worker_jobs.hpp"
#include "fem/solve_session.hpp"

namespace tedit::actors {

/// What a solver worker keeps between solves; used on its thread only.
struct kept_systems {
  std::map<std::string, std::unique_ptr<fem::backend>> devices;  ///< By the name asked for.
  fem::solve_session session;
};

struct solver_state {
  worker_jobs jobs;
  std::shared_ptr<kept_systems> systems = std::make_shared<kept_systems>();

  static inline const char* name = "solver";
};

/// Solves one order after the other.
solver_actor::behavior_type make_solver(solver_actor::stateful_pointer<solver_state> self,
                                        std::shared_ptr<page_cache> cache,
                                        const page_store_actor& pages);

/// Who hears of a solve while it runs.
struct solve_listener {
  fem::cases_callback on_frame;  ///< Of each outer round.
  /// Of the first field, once; never when load cases have different supports.
  std::function<void(job_output<solve_result>)> on_preview;
};

/// The job, without actors. A device that is lost is opened again once; then the processor solves,
/// and the report has a notice.
[[nodiscard]] expected<job_output<solve_result>> solve(const solve_order& order,
                                                       kept_systems& systems,
                                                       const version_ptr& mesh,
                                                       const execution& run,
                                                       const solve_listener& listener);

}  // namespace tedit::actors
