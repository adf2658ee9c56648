// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace tedit::fem {

/// Writes `result` = A x or B x; the vectors have `padding` floats more than unknowns.
using vector_map = std::function<void(const float* x, float* result)>;

/// Extreme eigenvalues of the tridiagonal matrix of conjugate gradients with these step lengths and
/// ratios beta of successive r.z; of beta, one less is used. 1 and 1 without any step.
struct ritz_range {
  double smallest = 1;
  double largest = 1;
};
[[nodiscard]] ritz_range extreme_ritz_values(std::span<const double> alpha,
                                             std::span<const double> beta);

/// The largest Ritz value of B A after `steps` steps of the Lanczos process that preconditioned
/// conjugate gradients run inside (Golub & Van Loan, section 10.2.6): a lower bound of the largest
/// eigenvalue, far better than as many power iterations. B symmetric positive semidefinite. The
/// start is B times a fixed noise vector, so the answer is the same every time. Stops early, with
/// what it has, when rounding breaks the process. Cost: one A and one B a step.
[[nodiscard]] float largest_ritz_value(std::size_t unknowns, std::size_t padding, int steps,
                                       const vector_map& a, const vector_map& b);

}  // namespace tedit::fem
