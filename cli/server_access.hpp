// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "client/types.hpp"

namespace CLI {
class App;
}

namespace tedit::cli {

/// How a command shows a running server who it is, and knows the server.
struct server_access {
  std::string token_file;   ///< Empty: where "tedit serve" puts it.
  std::string authority;    ///< PEM file of those that vouch for the server.
  std::string fingerprint;  ///< SHA-256 of its certificate.
};

/// --token-file, --server-ca and --trust.
void add_access_options(CLI::App& command, server_access& to);

/// How to connect to a running server. One of wss:// that is known by its certificate
/// (client/known_servers.hpp) must show that one, unless `access` says what it must show; one
/// whose fingerprint is given is known from then on, when it has shown it. Errors: those of
/// `load_config`, `token_path`, `read_token`, `known_servers::find`.
[[nodiscard]] expected<client::connect_options> reach_server(const std::string& url,
                                                             const server_access& access);

}  // namespace tedit::cli
