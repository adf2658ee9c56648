// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <numbers>
#include <string_view>

#include "base/error.hpp"

namespace tedit {

/// Radians.
inline constexpr double degree = std::numbers::pi / 180;

/// Metres per unit for "m", "cm", "mm", "um", "nm", "in" and "ft". Inside the program every length
/// is in metres; files state their unit at the border.
/// Errors: `invalid_argument` for any other name.
[[nodiscard]] expected<double> metres_per_unit(std::string_view unit);

}  // namespace tedit
