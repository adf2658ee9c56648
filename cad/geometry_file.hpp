// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "base/error.hpp"
#include "mesh/types.hpp"

namespace tedit::cad {

/// What each face is a piece of, in the order of `part_facts`, as the reader has left it in the
/// import's folder. Errors: `io_error`, `internal` for what no reader writes.
[[nodiscard]] expected<std::vector<surface_geometry>> load_geometries(
  const std::filesystem::path& folder);
[[nodiscard]] bool save_geometries(const std::vector<surface_geometry>& faces,
                                   const std::filesystem::path& folder);

}  // namespace tedit::cad
