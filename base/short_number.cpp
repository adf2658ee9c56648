// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/short_number.hpp"

#include <array>
#include <charconv>

namespace tedit {

std::string short_number(double value, std::size_t longest) {
  std::array<char, 32> text;
  // Adding zero makes -0 a plain 0.
  auto* end = std::to_chars(text.begin(), text.end(), value + 0.0).ptr;
  for (int digits = 16; end - text.begin() > static_cast<std::ptrdiff_t>(longest); --digits)
    end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, digits).ptr;
  return {text.begin(), end};
}

}  // namespace tedit
