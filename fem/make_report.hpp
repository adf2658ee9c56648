// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/load_cases.hpp"
#include "fem/solve_report.hpp"

namespace tedit {

/// The report of a solution, without `total_ms`.
[[nodiscard]] solve_report make_report(const mesh_version& mesh, const std::string& load_case,
                                       const fem::problem& problem, const fem::solution& result);

/// The reports of load cases that were solved together, and their envelope when there are several.
/// `total_ms` is shared among them.
[[nodiscard]] solve_outcome make_outcome(const mesh_version& mesh, const fem::case_set& set,
                                         const fem::solved_cases& result, bool interim,
                                         double total_ms);

/// What is worst over several load cases; of equal values the first counts. @pre there is one.
[[nodiscard]] solve_envelope make_envelope(const std::vector<solve_report>& cases);

}  // namespace tedit
