// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/line_cursor.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace tedit {

bool line_cursor::next() {
  if (again_) {
    again_ = false;
    return true;
  }
  if (end_ >= text_.size())
    return false;
  begin_ = end_;
  const auto stop = std::min(text_.find('\n', begin_), text_.size());
  end_ = stop + 1;
  line_ = text_.substr(begin_, stop - begin_);
  if (line_.ends_with('\r'))
    line_.remove_suffix(1);
  ++number_;
  return true;
}

void line_cursor::fail_here(ec code, std::string message, std::string remedy) const {
  if (remedy.empty())
    remedy = "Correct the line or write the file again";
  throw file_failure{
    {code, std::move(message), std::move(remedy), "line " + std::to_string(number_)}};
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\v\f";
  const auto first = text.find_first_not_of(blanks);
  if (first == text.npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (auto& c : result)
    if (c >= 'a' && c <= 'z')
      c = static_cast<char>(c - 'a' + 'A');
  return result;
}

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text;
  for (const char c : word.substr(0, longest))
    text += c >= 32 && c < 127 ? c : '?';
  return word.size() > longest ? text + "..." : text;
}

std::optional<std::int64_t> integer_of(std::string_view field) {
  auto word = trimmed(field);
  if (word.starts_with('+'))
    word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || code != std::errc{} || end != word.data() + word.size())
    return std::nullopt;
  return value;
}

namespace {

/// With an "e" before the exponent, as `from_chars` wants it. Empty where that is too long for a
/// number.
std::string_view with_letter(std::string_view word, std::array<char, 64>& room) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool sign = word[i] == '+' || word[i] == '-';
    const char before = i > 0 ? word[i - 1] : 'e';
    const bool bare = sign && (before == '.' || (before >= '0' && before <= '9'));
    if (size + 2 > room.size())
      return {};
    if (bare)
      room[size++] = 'e';
    room[size++] = word[i] == 'D' || word[i] == 'd' ? 'e' : word[i];
  }
  return {room.data(), size};
}

}  // namespace

std::optional<double> real_of(std::string_view field) {
  auto word = trimmed(field);
  if (word.starts_with('+'))
    word.remove_prefix(1);
  std::array<char, 64> room;
  word = with_letter(word, room);
  double value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size())
    return std::nullopt;
  // A number too small for a double reads as zero.
  if (code == std::errc::result_out_of_range && word.find("e-") != word.npos)
    return 0;
  if (code != std::errc{} || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::int64_t line_cursor::integer(std::string_view field, std::string_view what) const {
  if (const auto value = integer_of(field))
    return *value;
  fail_here(ec::bad_input,
            std::string(what) + " \"" + shown(trimmed(field)) + "\" is not a whole number",
            "Correct the line or write the file again");
}

std::uint64_t line_cursor::positive(std::string_view field, std::string_view what) const {
  const auto value = integer(field, what);
  if (value < 1)
    fail_here(ec::bad_input,
              std::string(what) + " is " + std::to_string(value) + ", numbers start at 1",
              "Correct the line or write the file again");
  return static_cast<std::uint64_t>(value);
}

double line_cursor::real(std::string_view field, std::string_view what) const {
  if (const auto value = real_of(field))
    return *value;
  fail_here(ec::bad_input,
            std::string(what) + " \"" + shown(trimmed(field)) + "\" is not a finite number",
            "Correct the line or write the file again");
}

std::optional<std::int64_t> number_at_end(std::string_view name) {
  const auto last = name.find_last_not_of("0123456789");
  const auto digits = last == name.npos ? name : name.substr(last + 1);
  const auto value = integer_of(digits);
  if (!value || *value > INT32_MAX)
    return std::nullopt;
  return value;
}

}  // namespace tedit
