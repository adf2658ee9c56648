// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace tedit::ops {

/// What passes between `tedit-mesher` and who started it, little-endian. In: header, points (3
/// doubles each), triangles (3 indices each). Out: header, all points (input ones first), tets (4
/// indices each).
struct exchange_header {
  std::uint32_t magic = 0x54544731;  // "TTG1"
  std::uint32_t points = 0;
  std::uint32_t cells = 0;    ///< Triangles in, tets out.
  std::uint32_t most_ms = 0;  ///< Of processor time, see `end_after`; 0 in an answer.
};

}  // namespace tedit::ops
