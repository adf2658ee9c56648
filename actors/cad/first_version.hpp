// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cad/model.hpp"
#include "fem/load_case.hpp"
#include "mesh/version.hpp"

namespace tedit::actors {

/// A part that begins a document.
struct first_version {
  version_ptr mesh;
  std::optional<cad::cad_model> model;  ///< None for a part that did not come from CAD.
  std::string file_name;                ///< Where it came from.
  std::vector<std::string> warnings;
  std::string client = "tedit";    ///< Who brought it, by name.
  std::string length_unit = "mm";  ///< Of that file.
  std::vector<fem::load_case> load_cases = {};
};

/// Makes a document with this version. Errors: `conflict` when something has the name; those of
/// `store::document`. Cost: that of writing it.
[[nodiscard]] expected<void> create_document(const std::filesystem::path& file,
                                             const first_version& first);

}  // namespace tedit::actors
