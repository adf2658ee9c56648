// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/config.hpp"

namespace CLI {
class App;
}

namespace tedit::cli {

/// What of the configuration can be given on the command line of `tedit serve`.
struct config_options {
  std::optional<std::filesystem::path> config_file;
  std::optional<std::string> address;
  std::optional<int> port;
  std::optional<std::string> documents;
  std::optional<std::string> token_file;
  std::optional<std::string> certificates;
  std::optional<std::string> node_certificates;
  std::optional<std::string> node_address;
  std::optional<int> node_port;
  std::optional<std::string> device;
  bool safe_mode = false;
};

/// Adds them to a command. @pre `options` lives as long as the command.
void add_config_options(CLI::App& command, config_options& options);

/// The configuration that holds: defaults, over them the file, over that the options. `origins`
/// says where each value that is no default comes from: "/etc/tedit/tedit.toml:12", "--port".
/// Errors: those of `load_config`.
[[nodiscard]] expected<server_config> effective_config(const config_options& given,
                                                       config_origins* origins = nullptr);

}  // namespace tedit::cli
