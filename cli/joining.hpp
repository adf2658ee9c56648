// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/command.hpp"

namespace tedit::cli {

/// Where a worker of this machine joins.
struct host_and_port {
  std::string host;
  std::uint16_t port = 0;
};

/// "rack-1:7465", "10.0.0.7:7465", "[::1]:7465". Errors: `usage`.
[[nodiscard]] expected<host_and_port> parse_place(const std::string& text);

/// Keeps a worker process (`command`, the program first) that joins a server, until `s` is
/// cancelled: when it dies, or the server goes, it is started anew, after a moment that grows from
/// half a second to half a minute as long as nothing comes of it, for one that was killed to four
/// seconds. Once cancelled it lets the
/// process end its work. Returns its exit status when a person must act first.
[[nodiscard]] int keep_joined(const std::vector<std::string>& command, session& s);

}  // namespace tedit::cli
