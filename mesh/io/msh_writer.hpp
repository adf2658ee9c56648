// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/io/file.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// Dense numbering of a version's live slots, as files want it.
struct compaction {
  std::vector<vertex_id> vertices;        ///< Slot of each file node, ascending.
  std::vector<std::uint32_t> file_index;  ///< File node (0-based) of each slot, no_id when free.
  std::vector<tet_id> tets;               ///< Slot of each file tet, ascending.
};

[[nodiscard]] compaction compact(const mesh_version& mesh);

/// Writes MSH 4.1 binary with surface ids as entity tags of dimension 2, region ids as entity tags
/// of dimension 3, and names as physical groups. Coordinates are written in `length_unit`.
/// Interface triangles are written, too. Errors: `io_error`, `invalid_argument` for the unit or for
/// ids beyond 32 bits.
[[nodiscard]] expected<void> write_msh(const file_target& to, const mesh_version& mesh,
                                       const std::string& length_unit);

}  // namespace tedit
