// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/execution.hpp"
#include "cli/config.hpp"
#include "cli/server_checks.hpp"

namespace tedit::cli {

/// What the port for workers of other machines would stumble over: its certificate, its list of
/// revoked ones. Changes nothing.
[[nodiscard]] std::vector<check_row> check_node_port(const server_config& config);

/// Whether this machine's clock is kept right: certificates need that. A clock that nobody keeps is
/// no failure, as it may be right all the same.
[[nodiscard]] check_row check_clock();

/// A worker's way to its server, as `tedit worker --join` would go it, without becoming a worker.
struct joining_check {
  std::string place;                   ///< HOST:PORT.
  std::filesystem::path certificates;  ///< Of this node.
};

/// Its own certificate, whether the server is reached and trusts it, versions, and how far the
/// clocks are apart. Takes up to some ten seconds.
[[nodiscard]] std::vector<check_row> check_joining(const joining_check& what,
                                                   const cancel_token& stop);

}  // namespace tedit::cli
