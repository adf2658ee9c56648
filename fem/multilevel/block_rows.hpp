// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/block_matrix.hpp"
#include "fem/multilevel/lanes.hpp"

/// Rows of products with a block matrix, y_i = sum_{j != i} K_ij (x_j - x_i).
namespace tedit::fem {

/// Reads the values of a matrix rounded to eight bits of mantissa: half the bytes.
struct rounded_values {
  loaded_halves high;

  TEDIT_INLINE rounded_values(const block_matrix& k, std::size_t entry) : high(k.high[entry]) {}

  template <int c>
  TEDIT_INLINE friend float4 column(const rounded_values& v) {
    return reinterpret_cast<float4>(upper_halves<c>(v.high));
  }
  /// Column c of two entries.
  template <int c>
  TEDIT_INLINE friend float8 columns(const rounded_values& v, const rounded_values& w) {
    return reinterpret_cast<float8>(upper_halves<c>(v.high, w.high));
  }
};

/// Reads them to the bit.
struct exact_values {
  loaded_halves high, low;

  TEDIT_INLINE exact_values(const block_matrix& k, std::size_t entry)
      : high(k.high[entry]), low(k.low[entry]) {}

  template <int c>
  TEDIT_INLINE friend float4 column(const exact_values& v) {
    return whole_column<c>(v.high, v.low);
  }
  template <int c>
  TEDIT_INLINE friend float8 columns(const exact_values& v, const exact_values& w) {
    return whole_columns<c>(v.high, v.low, w.high, w.low);
  }
};

/// Block of an entry times d.
template <class Values>
TEDIT_INLINE float4 entry_product(const block_matrix& k, std::size_t entry, float4 d) {
  const Values v(k, entry);
  return column<0>(v) * splat(d[0]) + column<1>(v) * splat(d[1]) + column<2>(v) * splat(d[2]);
}

template <class Values, std::size_t W>
TEDIT_INLINE node_lanes<W> entry_product(const block_matrix& k, std::size_t entry,
                                         const node_lanes<W>& d) {
  const Values v(k, entry);
  const float4 a = column<0>(v);
  const float4 b = column<1>(v);
  const float4 c = column<2>(v);
  return {a[0] * d.x + b[0] * d.y + c[0] * d.z, a[1] * d.x + b[1] * d.y + c[1] * d.z,
          a[2] * d.x + b[2] * d.y + c[2] * d.z};
}

/// Row i of K x: two blocks at a time. Behind an odd last one comes the node itself, whose
/// difference is zero: a branch for it is mispredicted in every second row.
template <class Values>
TEDIT_INLINE float4 row_of(const block_matrix& k, std::size_t i, const float* x, one_case) {
  const float4 own = load4(x + 3 * i);
  const float8 both = pair(own, own);
  const auto self = static_cast<std::uint32_t>(i);
  float8 sums{};
  for (std::size_t s = k.begin(i), last = k.end(i); s < last; s += 2) {
    const std::uint32_t* second = s + 1 < last ? &k.column[s + 1] : &self;
    const float8 d =
      pair(load4(x + 3 * std::size_t{k.column[s]}), load4(x + 3 * std::size_t{*second})) - both;
    const Values v(k, s);
    const Values w(k, s + 1);
    sums +=
      columns<0>(v, w) * each<0>(d) + columns<1>(v, w) * each<1>(d) + columns<2>(v, w) * each<2>(d);
  }
  return first_of(sums) + second_of(sums);
}

template <class Values, std::size_t W>
TEDIT_INLINE node_lanes<W> row_of(const block_matrix& k, std::size_t i, const float* x,
                                  cases_of<W>) {
  using L = cases_of<W>;
  const auto own = L::load(x, i);
  node_lanes<W> sum{};
  for (std::size_t s = k.begin(i), last = k.end(i); s < last; ++s)
    sum += entry_product<Values>(k, s, L::load(x, k.column[s]) - own);
  return sum;
}

/// The matrix as smoothers read it: rounded, but for some rows.
struct smoothed_matrix {
  const block_matrix& k;
  std::span<const std::uint8_t> exact;  ///< 1 for rows that are not; empty: there are none.

  [[nodiscard]] std::size_t rows() const { return k.rows(); }
};

/// A product with an operator on nodes with three unknowns each: calls `sink(i, y_i)` for the rows
/// of one chunk after the other, on all cores; what the sink returns, if anything, is summed for
/// each case. `block_matrix`, `smoothed_matrix` and the quadratic operator have this form.
template <class L = one_case, class Sink>
case_sums<L> for_rows(const block_matrix& k, const float* x, const Sink& sink) {
  return sum_lanes<L>(k.rows(),
                      [&](std::size_t first, std::size_t last, typename L::sum& sum) TEDIT_INLINED {
                        for (std::size_t i = first; i < last; ++i)
                          take_row<L>(sink, i, row_of<exact_values>(k, i, x, L{}), sum);
                      });
}

template <class L = one_case, class Sink>
case_sums<L> for_rows(const smoothed_matrix& m, const float* x, const Sink& sink) {
  return sum_lanes<L>(m.rows(),
                      [&](std::size_t first, std::size_t last, typename L::sum& sum) TEDIT_INLINED {
                        for (std::size_t i = first; i < last; ++i)
                          if (m.exact.empty() || m.exact[i] == 0)
                            take_row<L>(sink, i, row_of<rounded_values>(m.k, i, x, L{}), sum);
                          else
                            take_row<L>(sink, i, row_of<exact_values>(m.k, i, x, L{}), sum);
                      });
}

}  // namespace tedit::fem
