// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

#include "fem/problem.hpp"

namespace tedit::fem::native {

/// Bytes that assembling, solving and recovering `p` on the native backend take at their peak, on
/// top of the problem itself: per element and per node, fitted to measurements. What they are made
/// of, in bytes:
///
/// - linear tets, an element: the matrix 80 and incidence 16, while it is assembled gradients 104
///   beside them. A node: hierarchy 260 and as much again while it is built, vectors of the solver
///   96, solution and recovery 240. The peaks are not at the same time.
/// - quadratic tets: an element 60 and its patches' sums 60, the linear tets of the corners. A
/// node:
///   vectors 96, solution and recovery 250, its part of the corners' matrix and hierarchy.
///
/// Measured on nine medium parts (74 k to 149 k tets) and a cantilever of 176 k, orders 1 and 2,
/// and one of 942 k: 4 % to 13 % above the peak resident memory less that of the problem. Parts of
/// 20 k tets take a few MiB more that do not grow.
[[nodiscard]] std::uint64_t solve_bytes(const problem& p);

}  // namespace tedit::fem::native
