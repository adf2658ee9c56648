// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/messages.hpp"
#include "actors/supervisor/cost_model.hpp"

namespace tedit::actors {

/// What a job takes of a worker.
struct job_estimate {
  job_cost cost;
  double memory_bytes = 0;  ///< 0: not known.
};

/// Cost: none, but that the wanted operation or the load cases are read.
[[nodiscard]] job_estimate estimate(const import_order& order);
[[nodiscard]] job_estimate estimate(const edit_order& order);
[[nodiscard]] job_estimate estimate(const export_order& order);
[[nodiscard]] job_estimate estimate(const select_order& order);
[[nodiscard]] job_estimate estimate(const check_order& order);
[[nodiscard]] job_estimate estimate(const solve_order& order);

}  // namespace tedit::actors
