// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/nastran_card.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <ostream>

namespace tedit {

namespace {

/// With the point that makes it a real number.
std::string pointed(std::string text) {
  const auto exponent = text.find('e');
  if (text.find('.') == text.npos)
    text.insert(std::min(exponent, text.size()), 1, '.');
  std::ranges::replace(text, 'e', 'E');
  return text;
}

}  // namespace

std::string nastran_real(double value, std::size_t width) {
  std::array<char, 32> room;
  auto* end = std::to_chars(room.begin(), room.end(), value + 0.0).ptr;
  auto text = pointed({room.begin(), end});
  for (int digits = 16; text.size() > width && digits > 0; --digits) {
    end = std::to_chars(room.begin(), room.end(), value, std::chars_format::general, digits).ptr;
    text = pointed({room.begin(), end});
  }
  return text;
}

nastran_card::nastran_card(std::ostream& out, const std::string& name, bool is_wide)
    : out_(out), is_wide_(is_wide) {
  const auto first = is_wide ? name + "*" : name;
  out_ << first << std::string(8 - std::min<std::size_t>(8, first.size()), ' ');
}

nastran_card::~nastran_card() {
  out_ << '\n';
}

void nastran_card::put(const std::string& text) {
  if (on_line_ == (is_wide_ ? 4 : 8)) {
    out_ << (is_wide_ ? "\n*       " : "\n+       ");
    on_line_ = 0;
  }
  const std::size_t width = is_wide_ ? 16 : 8;
  out_ << text << std::string(width - std::min(width, text.size()), ' ');
  ++on_line_;
}

nastran_card& nastran_card::add(std::uint64_t number) {
  put(std::to_string(number));
  return *this;
}

nastran_card& nastran_card::add(double value) {
  put(nastran_real(value, is_wide_ ? 16 : 8));
  return *this;
}

nastran_card& nastran_card::add(const std::string& text) {
  put(text);
  return *this;
}

nastran_card& nastran_card::blank(int fields) {
  for (int i = 0; i < fields; ++i)
    put({});
  return *this;
}

}  // namespace tedit
