// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include <boost/asio/ip/tcp.hpp>

#include "actors/links/tls_identity.hpp"
#include "base/unique_fd.hpp"

/// For door.cpp and dial.cpp alone; what is heavy of asio::ssl stands in bridge.cpp.
namespace tedit::actors {

/// One TCP connection: a handshake with a limit, and after it bytes from TLS to one end of a link
/// and back. It has no thread: all of it happens on that of its `io_context`, on which each member
/// must be called and each callback comes. It lives as long as something is under way.
///
/// Each direction holds 64 KiB at most: who does not read stops who writes. Whatever ends one side,
/// its end of file too, ends the other at once. Writes raise no SIGPIPE.
class bridge {
public:
  using tcp_socket = boost::asio::ip::tcp::socket;
  using shaken = std::function<void(tl::expected<link_peer, tls_failure>)>;

  /// The handshake of the side that `context` was made for; the door's says welcome after it, the
  /// dial's waits for that. `done` comes once, with the peer, or with why there is none and the
  /// connection closed.
  /// @param host whom a dial means; its certificate must hold for it.
  [[nodiscard]] static std::shared_ptr<bridge> shake_hands(
    tcp_socket socket, std::shared_ptr<const tls_context> context, const std::string& host,
    std::chrono::milliseconds limit, shaken done);

  bridge() = default;
  bridge(const bridge&) = delete;
  bridge& operator=(const bridge&) = delete;
  virtual ~bridge() = default;

  /// After the handshake: carries bytes until either side ends. `ended` comes once.
  virtual void carry(unique_fd link, std::function<void()> ended) = 0;

  /// Ends it now. During the handshake `done` comes with `why`.
  virtual void cut(refusal why) = 0;
};

/// "10.0.0.7:51234", "[::1]:51234".
[[nodiscard]] std::string address_text(const boost::asio::ip::tcp::endpoint& where);

}  // namespace tedit::actors
