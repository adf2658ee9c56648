// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "fem/incidence.hpp"
#include "fem/rows.hpp"

namespace tedit::fem {

/// Four floats that live in one register; loads and stores need no alignment.
using float4 [[gnu::vector_size(16)]] = float;
using float4_anywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;

[[nodiscard]] inline float4 load4(const float* at) {
  return *reinterpret_cast<const float4_anywhere*>(at);
}

/// The three numbers of one node and a zero, for vectors that other threads change beside it:
/// `load4` would read the first number of the next node, unused, but a race all the same.
[[nodiscard]] inline float4 load3(const float* at) {
  return float4{at[0], at[1], at[2], 0};
}

/// Writes the first three numbers.
inline void store3(float4 value, float* at) {
  at[0] = value[0];
  at[1] = value[1];
  at[2] = value[2];
}

[[nodiscard]] inline float4 splat(float value) {
  return float4{value, value, value, value};
}

/// One float more than 3 per node, so that the last node can be loaded as four.
[[nodiscard]] constexpr std::size_t padded3(std::size_t nodes) {
  return 3 * nodes + 1;
}

/// A 3x3 block matrix in single precision and difference form: only the blocks beside the diagonal
/// are stored, and y_i = sum_{j != i} K_ij (x_j - x_i). Block rows sum to zero (rigid
/// translations), so the diagonal block is D_i = -sum K_ij. The form keeps rigid translations exact
/// and rotations to rounding of their differences; plain single precision is wrong by percents.
/// Memory: 40 bytes a block.
struct block_matrix {
  row_places places;                  ///< Of the rows in `column` and `value`.
  std::vector<std::uint32_t> column;  ///< Ascending within a row, without the diagonal.
  std::vector<float> value;           ///< 9 per entry, column by column, and 1 of padding; N/m.

  [[nodiscard]] std::size_t rows() const { return places.size(); }
  [[nodiscard]] std::uint32_t begin(std::size_t row) const { return places.begin(row); }
  [[nodiscard]] std::uint32_t end(std::size_t row) const { return places.end(row); }
  [[nodiscard]] std::uint64_t bytes() const {
    return places.bytes() + column.size() * 4 + value.size() * 4;
  }

  /// Row i of K x; x has `padded3` floats.
  [[nodiscard]] float4 row(std::size_t i, const float* x) const {
    const float4 own = load4(x + 3 * i);
    float4 sum{};
    for (auto s = begin(i), last = end(i); s < last; ++s) {
      const float4 d = load4(x + 3 * std::size_t{column[s]}) - own;
      const float* v = &value[9 * std::size_t{s}];
      sum += load4(v) * splat(d[0]) + load4(v + 3) * splat(d[1]) + load4(v + 6) * splat(d[2]);
    }
    return sum;
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

/// y = B x for a symmetric block.
[[nodiscard]] inline float4 multiply_symmetric(const std::array<float, 6>& b, float4 x) {
  return float4{b[0], b[1], b[2], 0} * splat(x[0]) + float4{b[1], b[3], b[4], 0} * splat(x[1]) +
         float4{b[2], b[4], b[5], 0} * splat(x[2]);
}

}  // namespace tedit::fem
