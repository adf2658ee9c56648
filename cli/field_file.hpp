// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "fem/load_cases.hpp"
#include "mesh/version.hpp"

namespace tedit::cli {

/// Writes the mesh with displacement, von Mises stress and stress tensor at nodes and elements as
/// VTU, in metres and pascals. Errors: `io_error`.
[[nodiscard]] expected<void> write_field(const std::filesystem::path& path,
                                         const mesh_version& mesh, const fem::problem& problem,
                                         const fem::solution& result);

/// The same of several load cases and their envelope (`fem::make_fields`), with the cases' names as
/// notes "case_0", "case_1", ...
[[nodiscard]] expected<void> write_field(const std::filesystem::path& path,
                                         const mesh_version& mesh, const fem::case_set& set,
                                         const fem::solved_cases& result);

}  // namespace tedit::cli
