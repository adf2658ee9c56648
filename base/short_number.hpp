// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace tedit {

/// The shortest text that reads back as `value`, or as many of its digits as `longest` characters
/// hold. Zero has no sign. `longest` is 8 at least.
[[nodiscard]] std::string short_number(double value, std::size_t longest);

}  // namespace tedit
