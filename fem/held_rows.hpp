// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "fem/problem.hpp"

namespace tedit::fem {

/// One held direction of a node as a row: u[dependent] + sum of factor[j] u[j] = value. Dependent
/// components of a node's rows are distinct, and no row has a factor for one of them.
struct held_row {
  int dependent = 0;
  std::array<double, 3> factor{};  ///< Zero for the dependent component.
  double value = 0;                ///< m.

  [[nodiscard]] bool oblique() const { return factor != std::array<double, 3>{}; }
};

/// The held directions of a node as rows, for decks of other solvers:
/// P u = z with P = 1 - S, reduced to as many rows as P has rank. P is a projector, so the largest
/// diagonal entry left is a safe pivot.
[[nodiscard]] std::vector<held_row> held_rows(const problem& p, std::size_t node);

}  // namespace tedit::fem
