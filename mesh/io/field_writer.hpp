// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/io/file.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// Writes a version with its fields as VTU: live vertices and tets in slot order, in metres, the
/// region id of each tet, and the notes as text. Errors: `io_error`. Cost: O(mesh).
[[nodiscard]] expected<void> write_vtu(
  const file_target& to, const mesh_version& mesh, const std::vector<field>& fields,
  const std::vector<std::pair<std::string, std::string>>& notes);

}  // namespace tedit
