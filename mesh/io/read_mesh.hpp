// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/build_version.hpp"
#include "mesh/deck.hpp"

namespace tedit {

/// What the reader of a format found.
struct read_mesh {
  raw_mesh mesh;
  std::vector<std::string> notices = {};  ///< What a person should know, one sentence each.
  std::string length_unit = {};           ///< Of coordinates, where the file says it; else empty.
  deck loads = {};                        ///< Vertices are places in `mesh.positions`.
};

}  // namespace tedit
