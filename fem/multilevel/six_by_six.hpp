// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/rigid_levels.hpp"
#include "fem/wide.hpp"

/// Products of 6x6 blocks in double precision, the main cost of coarser rows at set-up and after an
/// edit. For code inside `run_widest`.
namespace tedit::fem {

using double4 [[gnu::vector_size(32), gnu::may_alias]] = double;

/// A 6x6 block whose columns fill two registers each, two lanes of them unused.
class alignas(64) six_by_six {
public:
  /// Of a stored block.
  TEDIT_INLINE explicit six_by_six(const rigid_level::block6& from) {
    for (std::size_t c = 0; c < 6; ++c)
      for (std::size_t r = 0; r < 6; ++r)
        at(r, c) = static_cast<double>(from[6 * c + r]);
  }
  /// The transpose of a stored block.
  TEDIT_INLINE static six_by_six transposed(const rigid_level::block6& from) {
    six_by_six result;
    for (std::size_t c = 0; c < 6; ++c)
      for (std::size_t r = 0; r < 6; ++r)
        result.at(r, c) = static_cast<double>(from[6 * r + c]);
    return result;
  }

  /// sum += this * b, for a stored block.
  TEDIT_INLINE void add_product(const rigid_level::block6& b, row_sum::block& sum) const {
    // Converted at once: number by number that took as long as the product.
    alignas(32) std::array<double, 36> wide;
    for (std::size_t i = 0; i < wide.size(); i += 4)
      *reinterpret_cast<double4*>(&wide[i]) = __builtin_convertvector(load4(&b[i]), double4);
    add_product(wide.data(), sum);
  }
  /// The same for 36 numbers column by column.
  TEDIT_INLINE void add_product(const double* b, row_sum::block& sum) const {
    for (std::size_t c = 0; c < 6; ++c) {
      double4 first = four(&sum[8 * c]);
      double4 second = four(&sum[8 * c + 4]);
      for (std::size_t k = 0; k < 6; ++k) {
        const double factor = b[6 * c + k];
        first += four(&v_[8 * k]) * factor;
        second += four(&v_[8 * k + 4]) * factor;
      }
      four(&sum[8 * c]) = first;
      four(&sum[8 * c + 4]) = second;
    }
  }

private:
  using anywhere [[gnu::vector_size(32), gnu::aligned(16), gnu::may_alias]] = double;

  TEDIT_INLINE six_by_six() = default;
  TEDIT_INLINE double& at(std::size_t r, std::size_t c) { return v_[8 * c + r]; }
  TEDIT_INLINE static anywhere& four(double* at) { return *reinterpret_cast<anywhere*>(at); }
  TEDIT_INLINE static const anywhere& four(const double* at) {
    return *reinterpret_cast<const anywhere*>(at);
  }

  std::array<double, 48> v_{};
};

}  // namespace tedit::fem
