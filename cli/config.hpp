// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit::cli {

/// The server's options; config/tedit.toml explains each and holds the same defaults.
struct server_config {
  // [server]
  std::string address = "127.0.0.1";
  int port = 7464;
  std::vector<std::string> allowed_origins;
  std::vector<std::string> allowed_hosts;
  std::string certificates;  ///< Empty: without TLS.
  bool unencrypted_behind_proxy = false;
  std::string token_file;  ///< Empty: see `token_path`.
  std::string users_file;  ///< Empty: see `users_path`.
  std::string documents;   ///< Empty: see `documents_folder`.
  // [nodes]
  std::string node_certificates;  ///< In the file: certificates. Empty: no other machine joins.
  std::string node_address = "127.0.0.1";
  int node_port = 7465;
  // [work]
  std::string device = "auto";
  int modeling_workers = 1;
  int optimizer_workers = 1;
  int solver_workers = 1;
  int cad_jobs = 1;
  int import_jobs = 1;
  std::string sandbox = "auto";
  // [plugins]
  bool safe_mode = false;
  int quarantine_after = 3;
  // [limits]
  double edit_timeout_s = 120;
  double import_timeout_s = 600;
  double solve_timeout_s = 7200;
  double close_unused_after_s = 120;
  double keep_unnamed_s = 3600;
  int modeling_memory_mb = 0;
  std::int64_t upload_bytes = std::int64_t{2} << 30;
  std::int64_t all_upload_bytes = std::int64_t{4} << 30;
  std::int64_t result_bytes = std::int64_t{512} << 20;
  std::int64_t version_bytes = std::int64_t{512} << 20;
  // [log]
  std::string log_level = "info";  ///< In the file: level.
  std::string traces;              ///< Empty: none are kept.

  friend bool operator==(const server_config&, const server_config&) = default;
};

/// Where an option of a file stands: "server.port" -> "/etc/tedit/tedit.toml:12". What the file
/// leaves out has no row.
using config_origins = std::map<std::string, std::string>;

/// Reads one TOML file; what it leaves out keeps its default. Errors: `io_error`; `bad_input` with
/// file:line in `where` for bad TOML, an unknown name (the remedy has the nearest one), a value of
/// the wrong type or out of range.
[[nodiscard]] expected<server_config> read_config(const std::filesystem::path& file,
                                                  config_origins* origins = nullptr);

/// The options from `explicit_file` (--config) when given, else from the first of `config_files`
/// that is there, else the defaults. Errors: those of `read_config`.
[[nodiscard]] expected<server_config> load_config(
  const std::optional<std::filesystem::path>& explicit_file, config_origins* origins = nullptr);

/// Where a file is looked for: $XDG_CONFIG_HOME/tedit/config.toml (~/.config without the variable),
/// then /etc/tedit/tedit.toml.
[[nodiscard]] std::vector<std::filesystem::path> config_files();

/// Every option as the file has it: "server.address", "server.port", ...
[[nodiscard]] std::vector<std::string> config_keys();

/// The value of an option as the file would have it (TOML); empty for a key that is none.
[[nodiscard]] std::string config_text(const server_config& config, const std::string& key);

/// `documents`, or $XDG_STATE_HOME/tedit/documents (~/.local/state without the variable) when it is
/// empty. Errors: `invalid_argument` when neither XDG_STATE_HOME nor HOME is set.
[[nodiscard]] expected<std::filesystem::path> documents_folder(const server_config& config);

/// `token_file`, or tedit/token in the same place. Errors: as above.
[[nodiscard]] expected<std::filesystem::path> token_path(const server_config& config);

/// `users_file`, or users.sqlite beside the token. Errors: as above.
[[nodiscard]] expected<std::filesystem::path> users_path(const server_config& config);

}  // namespace tedit::cli
