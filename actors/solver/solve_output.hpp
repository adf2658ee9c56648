// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "actors/worker/worker_jobs.hpp"
#include "fem/load_cases.hpp"

namespace tedit::actors {

/// What a report says beside the numbers.
struct solve_facts {
  bool interim = false;
  double total_ms = 0;
  std::string notice = {};
  bool of_several = false;  ///< As in `solve_order`.
};

/// Fields and reports as others get them; what is interim goes to surfaces only.
[[nodiscard]] job_output<solve_result> make_solve_output(const mesh_version& mesh,
                                                         const fem::case_set& set,
                                                         const fem::solved_cases& solved,
                                                         const solve_facts& facts);

}  // namespace tedit::actors
