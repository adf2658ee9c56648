// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/worker/job_desk.hpp"
#include "fem/solver.hpp"

namespace tedit::actors {

/// The devices that a solver worker has opened, by the name that was asked for.
using device_map = std::map<std::string, std::unique_ptr<fem::backend>>;

struct solver_state {
  job_desk desk;
  std::shared_ptr<device_map> devices = std::make_shared<device_map>();  ///< Used on the bench.

  static inline const char* name = "solver";
};

/// Solves one order after the other.
solver_actor::behavior_type make_solver(solver_actor::stateful_pointer<solver_state> self,
                                        std::shared_ptr<page_cache> cache, page_store_actor pages);

/// The job, without actors; `on_frame` hears of each outer round.
[[nodiscard]] expected<job_output<solve_result>> solve(
  const solve_order& order, device_map& devices, const page_set& pages, const execution& run,
  const std::function<void(const fem::solve_frame&)>& on_frame);

}  // namespace tedit::actors
