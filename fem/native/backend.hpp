// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "fem/kernels.hpp"
#include "fem/multilevel/hierarchy.hpp"

namespace tedit::fem {

/// How the native backend solves; the defaults are measured (bench/FIGURES.md).
struct native_settings {
  multilevel_settings multilevel{.rounded = true};
  cycle_settings cycle;
  /// The linear tets under quadratic ones are solved more closely: degree 3 and smaller aggregates
  /// took 49 to 55 iterations where 2 and 0.1 took 58 to 65, in less time (thin parts, coarse).
  multilevel_settings corner_multilevel{
    .weak_edge = 0.15F, .sliver_condition = quadratic_sliver_condition, .rounded = true};
  cycle_settings corner_cycle{.node_degree = 3};
  /// Bytes that a solve may take; 0: what there is (base/memory.hpp). More is refused.
  std::uint64_t memory_limit = 0;
};

/// The backend on the CPU's cores: what runs without a GPU, and what other devices are compared
/// with. Single precision in difference form with a multilevel preconditioner; the outer loop of
/// `solve` makes the result exact to double precision. Several right-hand sides are solved up to
/// eight at a time on one read of everything but their own vectors, which take about 900 bytes a
/// node while the system stands.
[[nodiscard]] std::unique_ptr<backend> make_native_backend(const native_settings& settings = {});

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
[[nodiscard]] std::uint64_t native_solve_bytes(const problem& p);

}  // namespace tedit::fem
