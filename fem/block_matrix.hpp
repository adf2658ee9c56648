// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "base/raw_vector.hpp"
#include "fem/incidence.hpp"
#include "fem/rows.hpp"
#include "fem/split_float.hpp"

namespace tedit::fem {

/// A 3x3 block matrix in single precision and difference form: only the blocks beside the diagonal
/// are stored, and y_i = sum_{j != i} K_ij (x_j - x_i). Block rows sum to zero (rigid
/// translations), so the diagonal block is D_i = -sum K_ij. The form keeps rigid translations exact
/// and rotations to rounding of their differences; plain single precision is wrong by percents.
/// Values are split (fem/split_float.hpp), for smoothers that read only the upper halves.
/// Memory: 40 bytes a block.
struct block_matrix {
  /// Blocks behind the last entry: rows are read in pairs, and a block with what comes behind it.
  static constexpr std::ptrdiff_t padding = 2;
  static_assert(half_block_overread <= sizeof(half_block));

  row_places places;                  ///< Of the rows in the arrays below.
  std::vector<std::uint32_t> column;  ///< Ascending within a row, without the diagonal.
  raw_vector<half_block> high, low;   ///< Of each entry, and the padding; N/m.

  [[nodiscard]] std::size_t rows() const { return places.size(); }
  [[nodiscard]] std::uint32_t begin(std::size_t row) const { return places.begin(row); }
  [[nodiscard]] std::uint32_t end(std::size_t row) const { return places.end(row); }
  [[nodiscard]] std::uint64_t bytes() const {
    return places.bytes() + column.size() * 4 + (high.size() + low.size()) * sizeof(half_block);
  }

  /// The 9 numbers of an entry, column by column.
  [[nodiscard]] std::array<float, 9> block(std::size_t entry) const {
    std::array<float, 9> result;
    const loaded_halves upper(high[entry]);
    const loaded_halves lower(low[entry]);
    store3(whole_column<0>(upper, lower), &result[0]);
    store3(whole_column<1>(upper, lower), &result[3]);
    store3(whole_column<2>(upper, lower), &result[6]);
    return result;
  }
};

/// Builds pattern and values of the linear tets at the corners of a problem of any order, by
/// gathering over each node's elements: no atomics, the same bits every time. Block of an element:
/// K_ab = V [lambda g_a g_b^T + mu g_b g_a^T + mu (g_a.g_b) I], summed in double precision.
/// `corners` has the elements' corners.
[[nodiscard]] block_matrix assemble_blocks(const problem& p, const incidence& corners);

/// Gathers the rows of `nodes` again, and adds rows of new corners. Cost: O(rows).
void update_blocks(const problem& p, const incidence& corners, std::span<const std::uint32_t> nodes,
                   block_matrix& k);

/// A diagonal block D_i = -sum_{j != i} K_ij, symmetric: xx, xy, xz, yy, yz, zz.
[[nodiscard]] std::array<float, 6> diagonal_block(const block_matrix& k, std::size_t row);
[[nodiscard]] std::vector<std::array<float, 6>> diagonal_blocks(const block_matrix& k);

/// S (S D S + I - S)^-1 S: the inverse of D within the free directions of filter S.
[[nodiscard]] std::array<float, 6> invert_block(const std::array<float, 6>& diagonal,
                                                const std::array<double, 6>& filter);
[[nodiscard]] std::vector<std::array<float, 6>> invert_blocks(
  std::span<const std::array<float, 6>> diagonal, std::span<const std::array<double, 6>> filter);

}  // namespace tedit::fem
