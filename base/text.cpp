// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text.hpp"

#include <algorithm>
#include <cstdio>

namespace tedit {

namespace {

bool goes_on(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// Bytes of the character at the start of a text that is not empty; 0 when there is none.
/// The table is that of RFC 3629: the second byte's range keeps out surrogates and long forms.
std::size_t character_size(std::string_view text) noexcept {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80)
    return 1;
  const std::size_t size = first < 0xC2   ? 0
                           : first < 0xE0 ? 2
                           : first < 0xF0 ? 3
                           : first < 0xF5 ? 4
                                          : 0;
  if (size == 0 || text.size() < size ||
      !std::all_of(text.begin() + 1, text.begin() + size, goes_on))
    return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool too_low = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool too_high = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return too_low || too_high ? 0 : size;
}

}  // namespace

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const auto size = character_size(text);
    if (size == 0)
      return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string to_utf8(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const auto size = character_size(text);
    if (size == 0)
      result += "\uFFFD";
    else
      result += text.substr(0, size);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return result;
}

std::string_view cut_text(std::string_view text, std::size_t bytes) noexcept {
  if (text.size() <= bytes)
    return text;
  while (bytes > 0 && goes_on(text[bytes]))
    --bytes;
  return text.substr(0, bytes);
}

std::string format_number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

}  // namespace tedit
