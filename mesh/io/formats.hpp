// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/formats.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/read_mesh.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// Writes a version in the format of this name. Errors: `invalid_argument` for the name or the
/// unit, `io_error`, and what the format refuses. Cost: O(mesh).
[[nodiscard]] expected<void> write_as(std::string_view format, const file_target& to,
                                      const mesh_version& mesh, const file_terms& terms);

/// Reads a mesh in whatever format it is; what no row recognises is taken for a Gmsh mesh, whose
/// reader says what is wrong with it. Errors: `bad_input`; `unsupported_format`, also for a file of
/// a format that is only written.
[[nodiscard]] expected<read_mesh> read_any(std::span<const char> bytes);

}  // namespace tedit
