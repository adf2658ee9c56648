// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "actors/local_messages.hpp"

namespace tedit::actors {

/// Whether what a solver sent can be the result of these load cases on this mesh: reports of the
/// version and the cases that were asked for, with finite numbers; arrays that the program knows
/// (fem/quantities.hpp), each with a finite number for each slot. A solver may be anybody's.
/// Errors: `protocol_error`, naming what is wrong. Cost: O(fields).
[[nodiscard]] expected<void> check_solved(const solve_outcome& outcome,
                                          std::span<const field> fields, const mesh_version& mesh,
                                          const load_case_list& load_cases);

}  // namespace tedit::actors
