// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The host's services: CGAL for planar triangulation, the program `tedit-mesher` for tets. It is
/// looked for in $TEDIT_LIBEXEC, else beside the running executable.
[[nodiscard]] std::unique_ptr<services> make_host_services();

/// That program.
[[nodiscard]] std::filesystem::path mesher_program();

// -- two of them, apart (each in its own .cpp) ---------------------------------------------

[[nodiscard]] expected<planar_filling> triangulate_polygon(const planar_polygon& polygon,
                                                           double spacing);

/// Tets with a radius ratio below `least_quality` are an error.
[[nodiscard]] expected<tet_filling> tetrahedralise_surface(const closed_surface& shell,
                                                           const execution& run,
                                                           double least_quality = 1e-3);

}  // namespace tedit::ops
