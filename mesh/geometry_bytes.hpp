// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "base/byte_stream.hpp"
#include "mesh/types.hpp"

namespace tedit {

/// The least bytes that one takes.
inline constexpr std::size_t least_bytes_of_geometry = 1 + 8 + 2 * 4 + 4 * 8;

void write_geometry(const surface_geometry& geometry, byte_writer& out);

/// Nothing unless it is possible (`is_possible`). Sizes are checked against the bytes that are
/// there.
[[nodiscard]] std::optional<surface_geometry> read_geometry(byte_reader& in);

}  // namespace tedit
