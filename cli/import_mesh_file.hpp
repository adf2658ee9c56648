// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "fem/load_case.hpp"
#include "mesh/version.hpp"

namespace tedit::cli {

/// A mesh that becomes a document, or a mesh in another format.
struct mesh_import {
  std::filesystem::path file;
  std::string length_unit = "mm";  ///< Of its coordinates, where it does not say it.
  std::vector<std::string> load_cases;
  std::string output;
};

/// Whether a file is of a format whose meshes are read, by its suffix.
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& file);

/// The load cases that a new document shall have. Errors: `usage` where the output is none; those
/// of the files.
[[nodiscard]] expected<std::vector<fem::load_case>> first_load_cases(
  const std::vector<std::string>& files, const std::string& output);

/// That a mesh has all the surfaces that load cases name. Errors: `surface_not_found`, saying of
/// which load case.
[[nodiscard]] expected<void> check_load_cases(const mesh_version& mesh,
                                              const std::vector<fem::load_case>& load_cases);

int run_import_mesh(const mesh_import& wanted, session& s);

}  // namespace tedit::cli
