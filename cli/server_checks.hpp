// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tedit::cli {

/// One line of `tedit doctor`.
struct check_row {
  std::string name;
  bool ok = true;
  std::string text;
};

/// What `tedit serve` would stumble over: its configuration, the folder of the documents, the file
/// of the token, its port. Changes nothing. `config_file` is that of --config.
[[nodiscard]] std::vector<check_row> check_server(
  const std::optional<std::filesystem::path>& config_file);

}  // namespace tedit::cli
