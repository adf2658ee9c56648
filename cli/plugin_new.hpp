// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit::cli {

/// A plugin's folder that was made.
struct new_plugin {
  std::filesystem::path folder;
  std::vector<std::string> files;  ///< Inside the folder.
};

/// Writes PARENT/NAME with an operation that works, its test, a README and a CMakeLists.txt, which
/// builds against this program's installation or build tree. Errors: `usage` for a name that is not
/// snake_case of at most 40 characters; `io_error` when the folder is there or cannot be written:
/// then nothing is left of it.
[[nodiscard]] expected<new_plugin> make_plugin_folder(const std::string& name,
                                                      const std::filesystem::path& parent);

}  // namespace tedit::cli
