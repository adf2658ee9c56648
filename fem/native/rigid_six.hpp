// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/lanes.hpp"

namespace tedit::fem::native {

/// Aggregates of one piece of parallel work: each is worth about ten nodes.
inline constexpr std::size_t rigid_chunk = 512;

/// The six rigid motions of one aggregate, for each case.
template <class L>
struct alignas(4 * L::width) rigid_six {
  using scalar = typename L::scalar;

  std::array<scalar, 6> v{};

  [[nodiscard]] TEDIT_INLINE static rigid_six load(const float* x, std::size_t i) {
    return {{L::load_scalar(x, 6 * i), L::load_scalar(x, 6 * i + 1), L::load_scalar(x, 6 * i + 2),
             L::load_scalar(x, 6 * i + 3), L::load_scalar(x, 6 * i + 4),
             L::load_scalar(x, 6 * i + 5)}};
  }
  TEDIT_INLINE void store(float* x, std::size_t i) const {
    unrolled<6>([&](auto c) TEDIT_INLINED { L::store_scalar(v[c], x, 6 * i + c); });
  }
  /// Adds block * x.
  TEDIT_INLINE void add_product(const rigid_level::block6& block, const rigid_six& x) {
    unrolled<6>([&](auto c) TEDIT_INLINED {
      unrolled<6>([&](auto r) TEDIT_INLINED { v[r] += block[6 * c + r] * x.v[c]; });
    });
  }
  /// The same with the i-th motion of `x`.
  TEDIT_INLINE void add_product(const rigid_level::block6& block, const float* x, std::size_t i) {
    add_product(block, load(x, i));
  }
  /// Adds block^T * x.
  TEDIT_INLINE void add_transposed(const rigid_level::block6& block, const rigid_six& x) {
    unrolled<6>([&](auto c) TEDIT_INLINED {
      unrolled<6>([&](auto r) TEDIT_INLINED { v[c] += block[6 * c + r] * x.v[r]; });
    });
  }
  /// Adds the components given.
  TEDIT_INLINE void add(scalar a, scalar b, scalar c, scalar d, scalar e, scalar f) {
    v[0] += a, v[1] += b, v[2] += c, v[3] += d, v[4] += e, v[5] += f;
  }

  TEDIT_INLINE friend rigid_six operator+(const rigid_six& a, const rigid_six& b) {
    rigid_six sum;
    unrolled<6>([&](auto c) TEDIT_INLINED { sum.v[c] = a.v[c] + b.v[c]; });
    return sum;
  }
  TEDIT_INLINE friend rigid_six operator-(const rigid_six& a, const rigid_six& b) {
    rigid_six sum;
    unrolled<6>([&](auto c) TEDIT_INLINED { sum.v[c] = a.v[c] - b.v[c]; });
    return sum;
  }
  TEDIT_INLINE friend rigid_six operator*(float s, const rigid_six& a) {
    rigid_six product;
    unrolled<6>([&](auto c) TEDIT_INLINED { product.v[c] = s * a.v[c]; });
    return product;
  }
};

/// One case: the six numbers share a register with two that mean nothing.
template <>
struct rigid_six<one_case> {
  float8 v{};

  [[nodiscard]] TEDIT_INLINE static rigid_six load(const float* x, std::size_t i) {
    return {six_of(x + 6 * i)};
  }
  TEDIT_INLINE void store(float* x, std::size_t i) const {
    float* to = x + 6 * i;
    *reinterpret_cast<float4_anywhere*>(to) = first_of(v);
    to[4] = v[4];
    to[5] = v[5];
  }
  TEDIT_INLINE void add_product(const rigid_level::block6& block, const rigid_six& x) {
    // One addition to the sum for each block: the next one waits for it.
    v += (column<0>(block) * all<0>(x.v) + column<2>(block) * all<2>(x.v) +
          column<4>(block) * all<4>(x.v)) +
         (column<1>(block) * all<1>(x.v) + column<3>(block) * all<3>(x.v) +
          column<5>(block) * all<5>(x.v));
  }
  /// The same with the i-th motion of `x`, number by number from memory.
  TEDIT_INLINE void add_product(const rigid_level::block6& block, const float* x, std::size_t i) {
    const float* at = x + 6 * i;
    v += (column<0>(block) * at[0] + column<2>(block) * at[2] + column<4>(block) * at[4]) +
         (column<1>(block) * at[1] + column<3>(block) * at[3] + column<5>(block) * at[5]);
  }
  /// `x` as it was loaded, with zeros in the two lanes more.
  TEDIT_INLINE void add_transposed(const rigid_level::block6& block, const rigid_six& x) {
    const float8 first =
      sums_of_pairs(sums_of_pairs(column<0>(block) * x.v, column<1>(block) * x.v),
                    sums_of_pairs(column<2>(block) * x.v, column<3>(block) * x.v));
    const float8 second =
      sums_of_pairs(sums_of_pairs(column<4>(block) * x.v, column<5>(block) * x.v), float8{});
    v += pair(first_of(first) + second_of(first), first_of(second) + second_of(second));
  }
  TEDIT_INLINE void add(float a, float b, float c, float d, float e, float f) {
    v += float8{a, b, c, d, e, f, 0, 0};
  }

  TEDIT_INLINE friend rigid_six operator+(const rigid_six& a, const rigid_six& b) {
    return {a.v + b.v};
  }
  TEDIT_INLINE friend rigid_six operator-(const rigid_six& a, const rigid_six& b) {
    return {a.v - b.v};
  }
  TEDIT_INLINE friend rigid_six operator*(float s, const rigid_six& a) { return {s * a.v}; }

private:
  using anywhere [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;

  TEDIT_INLINE static float8 six_of(const float* at) {
    return pair(load4(at), float4{at[4], at[5], 0, 0});
  }
  /// The column and what lies behind it, which nobody looks at; behind the last one is nothing.
  template <int c>
  TEDIT_INLINE static float8 column(const rigid_level::block6& block) {
    if constexpr (c < 5)
      return *reinterpret_cast<const anywhere*>(&block[6 * c]);
    const float8 last = *reinterpret_cast<const anywhere*>(&block[28]);
    return __builtin_shufflevector(last, float8{}, 2, 3, 4, 5, 6, 7, 8, 9);
  }
  template <int i>
  TEDIT_INLINE static float8 all(float8 x) {
    return __builtin_shufflevector(x, x, i, i, i, i, i, i, i, i);
  }
  /// Of neighbouring lanes: in each half two of `a`, then two of `b`.
  TEDIT_INLINE static float8 sums_of_pairs(float8 a, float8 b) {
    return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14) +
           __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
  }
};

}  // namespace tedit::fem::native
