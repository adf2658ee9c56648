// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tedit {

/// Whether the bytes are UTF-8: no stray or missing bytes, no surrogates, nothing longer than it
/// needs to be, nothing above U+10FFFF. Cost: O(bytes).
[[nodiscard]] bool is_utf8(std::string_view text) noexcept;

/// The text without the mark of UTF-8 that some programs put before it.
[[nodiscard]] constexpr std::string_view without_mark(std::string_view text) noexcept {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

[[nodiscard]] constexpr std::span<const char> without_mark(std::span<const char> bytes) noexcept {
  return bytes.last(without_mark(std::string_view(bytes.data(), bytes.size())).size());
}

/// The text as UTF-8: each byte that belongs to no character becomes U+FFFD. What is UTF-8 stays.
[[nodiscard]] std::string to_utf8(std::string_view text);

/// The beginning of a UTF-8 text, at most `bytes` long, that ends with a whole character.
[[nodiscard]] std::string_view cut_text(std::string_view text, std::size_t bytes) noexcept;

/// A number as `printf` writes it with one format such as "%.4g"; at most 63 characters.
[[nodiscard]] std::string format_number(const char* format, double value);

/// "1, 2, 3".
template <class Numbers>
[[nodiscard]] std::string list_of(const Numbers& numbers, std::string_view between = ", ") {
  std::string text;
  for (const auto number : numbers)
    text += (text.empty() ? std::string() : std::string(between)) + std::to_string(number);
  return text;
}

}  // namespace tedit
