// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/socket.h>

#include <exception>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "base/logging/logging.hpp"
#include "base/unique_fd.hpp"

namespace tedit::actors {

/// A socket that no process which is started meanwhile inherits: asio would say so a moment after.
inline unique_fd private_socket(const boost::asio::ip::tcp& protocol) {
  return unique_fd(::socket(protocol.family(), SOCK_STREAM | SOCK_CLOEXEC, 0));
}

/// Runs until nothing is left to do. What throws costs its connection, and no other.
inline void run_io(boost::asio::io_context& io) {
  for (;;) {
    try {
      io.run();
      return;
    } catch (const std::exception& e) {
      logging::error("link: {}", e.what());
    }
  }
}

}  // namespace tedit::actors
