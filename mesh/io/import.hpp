// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/deck.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// A mesh that came from a file.
struct imported_mesh {
  version_ptr version;
  std::vector<std::string> warnings;  ///< What a person should know, one sentence each.
  std::string length_unit;            ///< Of the file's coordinates: as it says, else as asked.
  /// What the file says beside its mesh, in SI units; vertices are those of `version`.
  deck loads;
  double read_ms = 0;   ///< Reading and parsing.
  double build_ms = 0;  ///< Topology, surfaces and checks.
};

/// Reads a mesh in any format that is read (mesh/formats.hpp), told by its content. Its coordinates
/// are in the unit that the file says, else in `length_unit` ("mm", "m", "in", ...). Errors:
/// `invalid_argument` for the unit, `io_error`, `bad_input` and `unsupported_format` with the line
/// or byte offset in `where`. Nothing of a faulty file is used. Cost: linear; memory about three
/// times the version's pages.
[[nodiscard]] expected<imported_mesh> import_mesh(const std::filesystem::path& path,
                                                  const std::string& length_unit);

/// The same for the bytes of a file that is already in memory.
[[nodiscard]] expected<imported_mesh> import_mesh_bytes(std::span<const char> bytes,
                                                        const std::string& length_unit);
/// Likewise; they are let go once they were read.
[[nodiscard]] expected<imported_mesh> import_mesh_bytes(std::vector<char>&& bytes,
                                                        const std::string& length_unit);

}  // namespace tedit
