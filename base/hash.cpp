// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/hash.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tedit {

hash128 hash_bytes(std::span<const std::byte> bytes) noexcept {
  const auto value = XXH3_128bits(bytes.data(), bytes.size());
  return {value.high64, value.low64};
}

std::string to_hex(const hash128& hash) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text(32, '0');
  for (int i = 0; i < 16; ++i) {
    text[15 - i] = digits[(hash.high >> (4 * i)) & 0xF];
    text[31 - i] = digits[(hash.low >> (4 * i)) & 0xF];
  }
  return text;
}

std::optional<hash128> hash_from_hex(std::string_view text) noexcept {
  if (text.size() != 32)
    return std::nullopt;
  hash128 hash;
  for (int i = 0; i < 32; ++i) {
    const char c = text[i];
    int digit = 0;
    if (c >= '0' && c <= '9')
      digit = c - '0';
    else if (c >= 'a' && c <= 'f')
      digit = c - 'a' + 10;
    else
      return std::nullopt;
    auto& word = i < 16 ? hash.high : hash.low;
    word = (word << 4) | static_cast<std::uint64_t>(digit);
  }
  return hash;
}

}  // namespace tedit
