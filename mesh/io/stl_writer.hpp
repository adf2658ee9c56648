// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/io/file.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// Writes the boundary as binary STL in `length_unit`. STL keeps neither surface ids nor the unit.
/// Errors: `io_error`, `invalid_argument` for the unit.
[[nodiscard]] expected<void> write_stl(const file_target& to, const mesh_version& mesh,
                                       const std::string& length_unit);

}  // namespace tedit
