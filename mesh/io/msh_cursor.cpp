// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/msh_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tedit {

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

}  // namespace

std::string plain(std::string_view word) {
  std::string text;
  for (const char c : word.substr(0, 24))
    text += c >= 32 && c < 127 ? c : '?';
  return word.size() > 24 ? text + "..." : text;
}

std::string_view msh_cursor::word_here() {
  const std::size_t first = offset_;
  while (offset_ < bytes_.size() && !is_space(bytes_[offset_]))
    ++offset_;
  return text().substr(first, offset_ - first);
}

std::string_view msh_cursor::token() {
  while (offset_ < bytes_.size() && is_space(bytes_[offset_]))
    ++offset_;
  return word_here();
}

std::string_view msh_cursor::token_on_line() {
  while (offset_ < bytes_.size() && is_space(bytes_[offset_]) && bytes_[offset_] != '\n')
    ++offset_;
  return word_here();
}

std::string_view msh_cursor::rest_of_line() {
  const auto end = std::min(text().find('\n', offset_), bytes_.size());
  auto line = text().substr(offset_, end - offset_);
  offset_ = std::min(end + 1, bytes_.size());
  while (!line.empty() && is_space(line.back()))
    line.remove_suffix(1);
  return line;
}

void msh_cursor::skip_line_end() {
  (void)rest_of_line();
}

void msh_cursor::fail_number(std::string_view word, const std::string& what,
                             const char* kind) const {
  if (word.starts_with('$'))
    fail_here(ec::bad_input, plain(word) + " stands where " + what +
                               " should be: the section's counts and its content disagree");
  fail_here(ec::bad_input, what + " is \"" + plain(word) + "\", which is not " + kind);
}

template <class T>
T msh_cursor::parse(std::string_view word, const char* what) const {
  T value{};
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code == std::errc::result_out_of_range)
    fail_here(ec::bad_input, std::string(what) + " " + plain(word) + " is out of range");
  if (code != std::errc{} || end != word.data() + word.size())
    fail_number(word, what, std::is_signed_v<T> ? "a whole number" : "a whole number from 0 on");
  return value;
}

std::int64_t msh_cursor::integer(const char* what) {
  if (binary)
    return raw<std::int32_t>();
  const auto word = token();
  if (word.empty())
    fail_truncated();
  return parse<std::int64_t>(word, what);
}

std::int64_t msh_cursor::integer_on_line(const char* what) {
  const auto word = token_on_line();
  if (word.empty())
    fail_here(ec::bad_input, std::string("the line has too few numbers: ") + what + " is missing");
  return parse<std::int64_t>(word, what);
}

std::uint64_t msh_cursor::size(const char* what) {
  if (binary)
    return raw<std::uint64_t>();
  const auto word = token();
  if (word.empty())
    fail_truncated();
  return parse<std::uint64_t>(word, what);
}

double msh_cursor::real(const std::string& what) {
  if (binary) {
    const auto value = raw<double>();
    if (!std::isfinite(value))
      fail_here(ec::bad_input, what + " is not a finite number");
    return value;
  }
  const auto word = token();
  if (word.empty())
    fail_truncated();
  double value = 0;
  const auto* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [end, code] = std::from_chars(first, word.data() + word.size(), value);
  const bool whole = end == word.data() + word.size();
  // A number too small for a double reads as zero.
  if (code == std::errc::result_out_of_range && whole && word.find("e-") != word.npos)
    return 0;
  if (code != std::errc{} || !whole || !std::isfinite(value))
    fail_number(word, what, "a finite number");
  return value;
}

std::int32_t msh_cursor::raw_int() {
  return raw<std::int32_t>();
}

void msh_cursor::skip(std::size_t count) {
  if (count > left())
    fail_truncated();
  offset_ += count;
}

void msh_cursor::check_count(std::uint64_t count, std::size_t bytes_each, const char* what) {
  if (count > left() / bytes_each)
    fail_here(ec::bad_input,
              "the file says " + std::to_string(count) + " " + what + ", more than the " +
                std::to_string(left()) + " bytes that are left can hold",
              "The file is cut off or damaged: write it again");
}

void msh_cursor::fail_here(ec code, std::string message, std::string remedy) const {
  const auto done = text().substr(0, offset_);
  const auto place = binary ? "byte offset " + std::to_string(offset_)
                            : "line " + std::to_string(1 + std::ranges::count(done, '\n'));
  if (remedy.empty())
    remedy = "The file is damaged, or was written wrongly: write it again";
  throw msh_failure{
    {code, std::move(message), std::move(remedy), place + " (section " + section + ")"}};
}

void msh_cursor::fail_truncated() const {
  fail_here(ec::bad_input, "the file ends inside section " + section,
            "It is cut off: write or copy it again");
}

}  // namespace tedit
