// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

/// The log of this process: lines for who runs the program, on stderr. The library that writes them
/// is known to logging.cpp alone: its templates cost four seconds in each source that has one line.
namespace tedit::logging {

enum class level { debug, info, warn, error };

/// Sends the log to stderr from `from` on ("debug", "info", "warn", "error", "off"); `prefix`
/// stands before every line's text.
void start(const std::string& from, const std::string& prefix = {});

/// The least level that is written from now on, as above.
void set_level(const std::string& from);

/// A value in a line.
class value {
public:
  template <std::signed_integral T>
  value(T number) : held_(static_cast<long long>(number)) {}
  template <std::unsigned_integral T>
  value(T number) : held_(static_cast<unsigned long long>(number)) {}
  template <std::floating_point T>
  value(T number) : held_(static_cast<double>(number)) {}
  template <std::convertible_to<std::string_view> T>
  value(const T& text) : held_(std::string_view(text)) {}

  [[nodiscard]] const auto& held() const { return held_; }

private:
  std::variant<long long, unsigned long long, double, std::string_view> held_;
};

/// A line with `{}` for each of `Count` values, checked when it is compiled.
template <std::size_t Count>
class pattern {
public:
  consteval pattern(const char* text) : text_(text) {
    std::size_t places = 0;
    for (std::size_t i = 0; i + 1 < text_.size(); ++i)
      places += text_[i] == '{' && text_[i + 1] == '}';
    if (places != Count)
      throw "not one value for each {}";
  }

  [[nodiscard]] std::string_view text() const { return text_; }

private:
  std::string_view text_;
};

/// Thread-safe. Cost: next to nothing below the level that is written, else a write to stderr.
void write(level how, std::string_view text, std::initializer_list<value> values);

template <class... Values>
void debug(pattern<sizeof...(Values)> line, const Values&... values) {
  write(level::debug, line.text(), {value(values)...});
}

template <class... Values>
void info(pattern<sizeof...(Values)> line, const Values&... values) {
  write(level::info, line.text(), {value(values)...});
}

template <class... Values>
void warn(pattern<sizeof...(Values)> line, const Values&... values) {
  write(level::warn, line.text(), {value(values)...});
}

template <class... Values>
void error(pattern<sizeof...(Values)> line, const Values&... values) {
  write(level::error, line.text(), {value(values)...});
}

}  // namespace tedit::logging
