// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "client/types.hpp"

namespace tedit {
class server;
}

namespace tedit::cli {

/// A server inside this program, with worker processes of its own (plugins may crash) and a folder
/// for its documents that goes with it.
class embedded_server {
public:
  embedded_server();
  embedded_server(const embedded_server&) = delete;
  embedded_server& operator=(const embedded_server&) = delete;
  ~embedded_server();

  /// Starts it with so many workers of each kind; returns how to reach it. Errors: those of
  /// `server::start`, `io_error` for its folder.
  [[nodiscard]] expected<client::connect_options> start(unsigned workers);

private:
  std::filesystem::path folder_;
  std::unique_ptr<server> server_;
};

}  // namespace tedit::cli
