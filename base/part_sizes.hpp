// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace tedit {

/// How fine a part of a CAD or surface file may be meshed: docs/cad.md, *Sizes*.
inline constexpr std::array<std::string_view, 3> part_sizes{"coarse", "medium", "fine"};

}  // namespace tedit
