// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

#include "fem/problem.hpp"

namespace tedit::fem {

/// Bytes that assembling, solving and recovering `p` on the native backend take at their peak, on
/// top of the problem itself: per element and per node, measured, with 5 % on top. What they are
/// made of, in bytes:
///
/// - linear tets, an element: the matrix 80 and incidence 16; while it is assembled gradients 104,
///   afterwards, in the same place, the graph of the hierarchy 16 and the stresses 140.
///   A node: matrix and incidence 120, hierarchy 260 and as much again while it is built, vectors
///   of the solver 96, solution and recovery 230.
/// - quadratic tets: an element 60 and its patches' sums 60, element stresses 250 at corners and
///   means, the linear tets of the corners. A node: vectors 96, solution and recovery 420, its part
///   of the corners' matrix and hierarchy.
///
/// Measured on the coarse and medium plate and three other medium parts, orders 1 and 2: 0 % to
/// +11 % above the peak resident memory.
[[nodiscard]] std::uint64_t native_solve_bytes(const problem& p);

}  // namespace tedit::fem
