// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/error.hpp"

namespace tedit {

/// What a number that comes from outside may be, both ends included.
struct number_range {
  double least = 0;
  double most = 0;
  std::string unit;  ///< For the message: "Pa"; empty for ratios and counts.
};

/// The largest number of any quantity, in its SI unit: products of several still are numbers.
inline constexpr double largest_number = 1e30;

/// Any finite number that sums and products can be made of: up to `largest_number` in size.
[[nodiscard]] number_range any_number(std::string unit = {});

/// Any number but nan and the infinities.
[[nodiscard]] number_range finite_number(std::string unit = {});

/// "nan", "-9.81", "1e+40": as people write it in a file.
[[nodiscard]] std::string number_text(double value);

/// Every number that a file, a message, a recipe or a command line brings goes through here, each
/// component of a vector by itself: a norm may hide one that is none. `name` says which it is.
/// Errors: `code` with name, value and unit; the remedy has the range.
[[nodiscard]] expected<void> check_number(double value, const number_range& range,
                                          const std::string& name, ec code = ec::invalid_argument);

}  // namespace tedit
