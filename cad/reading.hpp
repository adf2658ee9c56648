// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>

namespace tedit::cad {

// What the reader is asked for: the last of its arguments.
inline constexpr std::string_view reads_all = "with-annotations";
inline constexpr std::string_view reads_plain = "without-annotations";
inline constexpr std::string_view reads_text = "faults-of-text";  ///< Why it cannot be read.

}  // namespace tedit::cad
