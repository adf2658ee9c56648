// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <utility>

/// Registers of four and eight floats and of four doubles, and code that exists once for machines
/// with AVX2 and once for all others.
namespace tedit::fem {

// Vectors wider than 16 bytes only live inside one function: all that takes or returns them is
// inlined into a body that exists once for AVX2 and once for any machine.
#define TEDIT_INLINE [[gnu::always_inline]] inline
/// Behind the parameters of a lambda.
#define TEDIT_INLINED __attribute__((always_inline))

/// Calls body(), which is inlined, with AVX2 where the machine has it.
#if defined(__x86_64__)
template <class Body>
[[gnu::target("avx2,fma")]] void run_with_avx2(const Body& body) {
  body();
}

template <class Body>
[[gnu::target("avx2")]] void run_with_avx2_unfused(const Body& body) {
  body();
}

template <class Body>
void run_widest(const Body& body) {
  static const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx2)
    run_with_avx2(body);
  else
    body();
}

/// The same without fused products: the bits are those of any machine.
template <class Body>
void run_wide_unfused(const Body& body) {
  static const bool avx2 = __builtin_cpu_supports("avx2");
  if (avx2)
    run_with_avx2_unfused(body);
  else
    body();
}
#else
template <class Body>
void run_wide_unfused(const Body& body) {
  body();
}

template <class Body>
void run_widest(const Body& body) {
  body();
}
#endif

/// body(0), ..., body(N - 1), each with a constant. A loop is not unrolled before arrays are cut
/// into registers: what it indexes stays in memory, and sums wait for their own stores.
template <std::size_t N, class Body>
TEDIT_INLINE void unrolled(const Body& body) {
  [&]<std::size_t... I>(std::index_sequence<I...>) TEDIT_INLINED {
    (body(std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<N>{});
}

/// Four floats that live in one register; loads and stores need no alignment.
using float4 [[gnu::vector_size(16)]] = float;
using float4_anywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;

[[nodiscard, gnu::always_inline]] inline float4 load4(const float* at) {
  return *reinterpret_cast<const float4_anywhere*>(at);
}

/// The three numbers of one node and a zero, for vectors that other threads change beside it:
/// `load4` would read the first number of the next node, unused, but a race all the same.
[[nodiscard, gnu::always_inline]] inline float4 load3(const float* at) {
  return float4{at[0], at[1], at[2], 0};
}

/// Writes the first three numbers.
[[gnu::always_inline]] inline void store3(float4 value, float* at) {
  at[0] = value[0];
  at[1] = value[1];
  at[2] = value[2];
}

[[nodiscard, gnu::always_inline]] inline float4 splat(float value) {
  return float4{value, value, value, value};
}

/// Eight floats: two nodes or two columns of blocks side by side, one lane of each unused.
using float8 [[gnu::vector_size(32)]] = float;

using double4 [[gnu::vector_size(32)]] = double;
using double4_anywhere [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

TEDIT_INLINE float8 pair(float4 first, float4 second) {
  return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
}

TEDIT_INLINE float4 first_of(float8 x) {
  return __builtin_shufflevector(x, x, 0, 1, 2, 3);
}

TEDIT_INLINE float4 second_of(float8 x) {
  return __builtin_shufflevector(x, x, 4, 5, 6, 7);
}

/// Component `i` of each half in all of its lanes.
template <int i>
TEDIT_INLINE float8 each(float8 x) {
  return __builtin_shufflevector(x, x, i, i, i, i, i + 4, i + 4, i + 4, i + 4);
}

/// One float more than 3 per node, so that the last node can be loaded as four.
[[nodiscard]] constexpr std::size_t padded3(std::size_t nodes) {
  return 3 * nodes + 1;
}

/// y = B x for a symmetric block.
[[nodiscard, gnu::always_inline]] inline float4 multiply_symmetric(const std::array<float, 6>& b,
                                                                   float4 x) {
  return float4{b[0], b[1], b[2], 0} * splat(x[0]) + float4{b[1], b[3], b[4], 0} * splat(x[1]) +
         float4{b[2], b[4], b[5], 0} * splat(x[2]);
}

}  // namespace tedit::fem
