// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "fem/wide.hpp"

/// Blocks of nine single-precision numbers in two halves of 16 bits each. The upper half is the
/// number rounded to eight bits of mantissa (bfloat16), the lower one what that lacks, in units of
/// the number's last place. Both together are the number to the bit; who can do with a rounded one
/// reads half the bytes.
namespace tedit::fem {

using uint4 [[gnu::vector_size(16)]] = std::uint32_t;
using int4 [[gnu::vector_size(16)]] = std::int32_t;
using int8 [[gnu::vector_size(32)]] = std::int32_t;
using ushort8 [[gnu::vector_size(16)]] = std::uint16_t;
using ushort16 [[gnu::vector_size(32)]] = std::uint16_t;

/// The halves of a block v, column by column: v0 v3, v1 v4, v2 v5 - so that a register of 32 bits a
/// lane has column 0 in its lower and column 1 in its upper halves - then v6 v7 v8.
using half_block = std::array<std::uint16_t, 9>;
static_assert(sizeof(half_block) == 18);

/// Bytes behind a block that may be read with it; what they are does not matter.
inline constexpr std::size_t half_block_overread = 10;

/// Stores the lower halves of three registers as the columns of a block.
TEDIT_INLINE void store_halves(const std::array<uint4, 3>& column, half_block& to) {
  const uint4 first = (column[0] & 0xFFFFU) | (column[1] << 16);
  for (std::size_t row = 0; row < 3; ++row) {
    std::memcpy(&to[2 * row], reinterpret_cast<const char*>(&first) + 4 * row, 4);
    to[6 + row] = static_cast<std::uint16_t>(column[2][row]);
  }
}

/// Splits a block of finite numbers, column by column.
TEDIT_INLINE void split_block(const std::array<float4, 3>& column, half_block& high,
                              half_block& low) {
  std::array<uint4, 3> rounded;
  std::array<uint4, 3> rest;
  unrolled<3>([&](auto c) TEDIT_INLINED {
    const auto bits = reinterpret_cast<uint4>(column[c]);
    rounded[c] = (bits + 0x8000U) >> 16;
    rest[c] = bits - (rounded[c] << 16);
  });
  store_halves(rounded, high);
  store_halves(rest, low);
}

/// A block as it was loaded: columns 0 and 1, and column 2 from its third 32 bits on.
struct loaded_halves {
  float4 first, last;

  TEDIT_INLINE explicit loaded_halves(const half_block& b)
      : first(bytes_at(b, 0)), last(bytes_at(b, 12)) {}

private:
  using anywhere [[gnu::vector_size(16), gnu::aligned(2), gnu::may_alias]] = float;
  TEDIT_INLINE static float4 bytes_at(const half_block& b, std::size_t offset) {
    return *reinterpret_cast<const anywhere*>(reinterpret_cast<const char*>(b.data()) + offset);
  }
};

/// The halves of column c in the upper halves of 32 bits, four and eight numbers; of each four the
/// last one means nothing.
template <int c>
TEDIT_INLINE int4 upper_halves(const loaded_halves& b) {
  if constexpr (c == 0)
    return reinterpret_cast<int4>(b.first) << 16;
  if constexpr (c == 1)
    return reinterpret_cast<int4>(b.first) & ~0xFFFF;
  return reinterpret_cast<int4>(__builtin_shufflevector(
    ushort8{}, reinterpret_cast<ushort8>(b.last), 0, 8, 1, 9, 2, 10, 3, 11));
}

/// Column c to the bit: lower halves have a sign.
template <int c>
TEDIT_INLINE float4 whole_column(const loaded_halves& high, const loaded_halves& low) {
  return reinterpret_cast<float4>(upper_halves<c>(high) + (upper_halves<c>(low) >> 16));
}

template <int c>
TEDIT_INLINE int8 upper_halves(const loaded_halves& a, const loaded_halves& b) {
  const auto first = reinterpret_cast<int8>(pair(a.first, b.first));
  if constexpr (c == 0)
    return first << 16;
  if constexpr (c == 1)
    return first & ~0xFFFF;
  return reinterpret_cast<int8>(
    __builtin_shufflevector(ushort16{}, reinterpret_cast<ushort16>(pair(a.last, b.last)), 0, 16, 1,
                            17, 2, 18, 3, 19, 8, 24, 9, 25, 10, 26, 11, 27));
}

/// Column c of two blocks to the bit.
template <int c>
TEDIT_INLINE float8 whole_columns(const loaded_halves& high, const loaded_halves& low,
                                  const loaded_halves& next_high, const loaded_halves& next_low) {
  return reinterpret_cast<float8>(upper_halves<c>(high, next_high) +
                                  (upper_halves<c>(low, next_low) >> 16));
}

}  // namespace tedit::fem
