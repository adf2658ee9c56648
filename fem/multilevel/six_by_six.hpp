// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/rigid_levels.hpp"
#include "fem/wide.hpp"

/// Products of 6x6 blocks in double precision, the main cost of coarser rows at set-up and after an
/// edit. For code inside `run_widest`.
namespace tedit::fem {

/// A 6x6 block whose columns fill two registers each, two lanes of them unused.
class alignas(64) six_by_six {
public:
  /// Of a stored block.
  TEDIT_INLINE explicit six_by_six(const rigid_level::block6& from) {
    unrolled<6>([&](auto c)
                  TEDIT_INLINED { set(c, &from[6 * c], std::integral_constant<int, 1>{}); });
  }
  /// The transpose of a stored block.
  TEDIT_INLINE static six_by_six transposed(const rigid_level::block6& from) {
    six_by_six result;
    unrolled<6>([&](auto c)
                  TEDIT_INLINED { result.set(c, &from[c], std::integral_constant<int, 6>{}); });
    return result;
  }

  /// sum += this * b, for a stored block.
  TEDIT_INLINE void add_product(const rigid_level::block6& b, row_sum::block& sum) const {
    // Converted at once: number by number that took as long as the product.
    alignas(32) std::array<double, 36> wide;
    for (std::size_t i = 0; i < wide.size(); i += 4)
      four(&wide[i]) = __builtin_convertvector(load4(&b[i]), double4);
    add_product(wide.data(), sum);
  }
  /// The same for 36 numbers column by column.
  TEDIT_INLINE void add_product(const double* b, row_sum::block& sum) const {
    for (std::size_t c = 0; c < 6; ++c) {
      double4 first = four(&sum[8 * c]);
      double4 second = four(&sum[8 * c + 4]);
      unrolled<6>([&](auto k) TEDIT_INLINED {
        const double factor = b[6 * c + k];
        first += v_[2 * k] * factor;
        second += v_[2 * k + 1] * factor;
      });
      four(&sum[8 * c]) = first;
      four(&sum[8 * c + 4]) = second;
    }
  }

private:
  using anywhere [[gnu::vector_size(32), gnu::aligned(16), gnu::may_alias]] = double;

  TEDIT_INLINE six_by_six() = default;
  /// Column c: six numbers, each `step` behind the one before.
  template <std::size_t c, int step>
  TEDIT_INLINE void set(std::integral_constant<std::size_t, c>, const float* from,
                        std::integral_constant<int, step>) {
    const float4 first{from[0], from[step], from[2 * step], from[3 * step]};
    const float4 second{from[4 * step], from[5 * step], 0, 0};
    v_[2 * c] = __builtin_convertvector(first, double4);
    v_[2 * c + 1] = __builtin_convertvector(second, double4);
  }
  TEDIT_INLINE static anywhere& four(double* at) { return *reinterpret_cast<anywhere*>(at); }
  TEDIT_INLINE static const anywhere& four(const double* at) {
    return *reinterpret_cast<const anywhere*>(at);
  }

  std::array<double4, 12> v_;  ///< Two for each column.
};

}  // namespace tedit::fem
