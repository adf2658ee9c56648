// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace tedit::bench {

/// The first eight bytes of a system file: "TESYSTM1".
inline constexpr std::uint64_t system_magic = 0x314d545359534554;

}  // namespace tedit::bench
