// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "cad/import.hpp"

namespace tedit::cad {

/// Makes a part's version, report and warnings of what a mesher left in its folder, by the names of
/// the part's facts.
/// @param geometries of the faces, in their order; none where nobody knows them.
/// Errors: `io_error`, `internal`, those of `build_version`. Cost: O(mesh).
[[nodiscard]] expected<void> take_mesh(const std::filesystem::path& folder, imported_part& part,
                                       const std::vector<surface_geometry>& geometries = {});

}  // namespace tedit::cad
