// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "fem/solver.hpp"
#include "mesh/finish_edit.hpp"

namespace tedit {

struct adapt_goal {
  double error = 0.05;              ///< Wanted relative error in the energy norm, as estimated.
  std::size_t most_tets = 1000000;  ///< That a round may leave.
};

/// The estimate of one load case.
struct case_error {
  std::span<const float> elements;  ///< sqrt(J), of each element: fem::solution::element_error.
  double energy_j = 0;              ///< 2 U + sum eta^2.
};

/// A version that is finer where the estimated error of one of the cases is larger than its share:
/// elements are to have equal errors that make the wanted one together. Each goes to what an error
/// of order h^(order + 3/2) asks for, at most to half of its size; around it sizes grow as for
/// `split_edges`. All that holds for an edit is checked. Errors: `invalid_parameter` when more tets
/// would come out than allowed even where only the worst is refined; those of `finish_edit`.
/// Cost: O(mesh + new tets).
[[nodiscard]] expected<finished_edit> refine_by_error(const version_ptr& mesh,
                                                      const fem::problem& problem,
                                                      std::span<const case_error> cases,
                                                      const adapt_goal& goal, const execution& run);

}  // namespace tedit
