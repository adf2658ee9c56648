// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "fem/incidence.hpp"

namespace tedit::fem {

/// A 3x3 block, row-major, N/m.
using block3 = std::array<double, 9>;

/// The stiffness matrix in difference form: only the blocks beside the diagonal are stored, and
/// y_i = sum_{j != i} K_ij (x_j - x_i). Block rows sum to zero (rigid translations), so the
/// diagonal block is D_i = -sum K_ij. The form keeps rigid-body motions exact to rounding.
struct block_matrix {
  std::vector<std::uint32_t> first;   ///< Start of each row in `column` and `block`; rows + 1.
  std::vector<std::uint32_t> column;  ///< Ascending within a row, without the diagonal.
  std::vector<block3> block;

  [[nodiscard]] std::size_t rows() const { return first.size() - 1; }
};

/// Builds pattern and values by gathering over each node's elements: no atomics, the same bits
/// every time. Block of an element: K_ab = V [lambda g_a g_b^T + mu g_b g_a^T + mu (g_a.g_b) I].
[[nodiscard]] block_matrix assemble_blocks(const problem& p, const incidence& corners);

/// y = K x, 3 values per row.
void multiply(const block_matrix& k, std::span<const double> x, std::span<double> y);

/// The diagonal blocks D_i = -sum_{j != i} K_ij.
[[nodiscard]] std::vector<block3> diagonal_blocks(const block_matrix& k);

}  // namespace tedit::fem
