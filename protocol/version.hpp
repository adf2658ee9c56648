// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace tedit::protocol {

/// Client and server must say the same: until 1.0 every minor may change what messages mean.
inline constexpr std::uint32_t major_version = 1;
inline constexpr std::uint32_t minor_version = 10;

}  // namespace tedit::protocol
