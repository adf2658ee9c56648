// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// A mesh that came from a file.
struct imported_mesh {
  version_ptr version;
  std::vector<std::string> warnings;  ///< What a person should know, one sentence each.
  double read_ms = 0;                 ///< Reading and parsing.
  double build_ms = 0;                ///< Topology, surfaces and checks.
};

/// Reads a Gmsh mesh (MSH 2.2 or 4.1, ASCII or binary) whose coordinates are in `length_unit`
/// ("mm", "m", "in", ...). Errors: `invalid_argument` for the unit, `io_error`, `bad_input` and
/// `unsupported_format` with the line or byte offset in `where`. Nothing of a faulty file is used.
/// Cost: linear; memory about three times the file.
[[nodiscard]] expected<imported_mesh> import_mesh(const std::filesystem::path& path,
                                                  const std::string& length_unit);

/// The same for the bytes of a file that is already in memory.
[[nodiscard]] expected<imported_mesh> import_mesh_bytes(std::span<const char> bytes,
                                                        const std::string& length_unit);

}  // namespace tedit
