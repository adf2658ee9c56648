// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/number_range.hpp"

#include <cstdio>
#include <limits>

namespace tedit {

number_range any_number(std::string unit) {
  return {-largest_number, largest_number, std::move(unit)};
}

number_range finite_number(std::string unit) {
  constexpr double most = std::numeric_limits<double>::max();
  return {-most, most, std::move(unit)};
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

expected<void> check_number(double value, const number_range& range, const std::string& name,
                            ec code) {
  if (value >= range.least && value <= range.most)  // False for nan.
    return {};
  const auto unit = range.unit.empty() ? "" : " " + range.unit;
  const bool any = range.most == std::numeric_limits<double>::max();
  return fail(code, name + " is " + number_text(value) + unit,
              any ? std::string("Give a finite number")
                  : "Give a number from " + number_text(range.least) + " to " +
                      number_text(range.most) + unit);
}

}  // namespace tedit
