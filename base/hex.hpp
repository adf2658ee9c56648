// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace tedit {

/// Two small hexadecimal digits for each byte, the higher first.
[[nodiscard]] inline std::string to_hex(std::span<const unsigned char> bytes) {
  constexpr auto digits = "0123456789abcdef";
  std::string text;
  for (const auto b : bytes) {
    text += digits[b >> 4];
    text += digits[b & 15];
  }
  return text;
}

}  // namespace tedit
