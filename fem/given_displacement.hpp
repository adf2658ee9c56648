// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/element_operator.hpp"
#include "fem/solver.hpp"

namespace tedit::fem {

/// What a displacement of somebody else's may leave to count as a solution: of the true residual,
/// and of |d.r| / max(|d.Sf|, |d.Kd|), where d is the displacement and r the residual. Seven digits
/// leave much of the former on fine meshes, where neighbours move alike (2.7e-3 on a plate of 22 k
/// tets, seven times that on one of 1 M), and hardly any of the latter; a displacement that is
/// wrong by a factor leaves both.
inline constexpr double most_given_residual = 0.1;
inline constexpr double most_given_imbalance = 1e-3;

/// The solution that a displacement (m, 3 per node) found elsewhere is: all that follows from it,
/// with its true residual. Held directions get their prescribed values first, so that a
/// displacement that ignores them shows as a residual. `converged`, as there is nothing better to
/// wait for. Errors: `bad_input` for another length or numbers that are not finite;
/// `not_converged` beyond the bounds above; those of `recover`. Cost: O(mesh).
[[nodiscard]] expected<solution> solution_of(const problem& p, const element_operator& k,
                                             std::vector<double> displacement, std::string device);

}  // namespace tedit::fem
