// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "client/types.hpp"

namespace tedit::client {

/// The largest message that is received, bytes; a larger one ends the connection.
inline constexpr std::size_t max_incoming_message = std::size_t{16} << 20;

/// What a socket tells; called from its I/O thread, one at a time. They must not call `close` or
/// destroy the socket.
struct socket_callbacks {
  std::function<void(std::string_view message)> on_message;  ///< Valid during the call.
  std::function<void(const error& reason)> on_closed;        ///< Once, after `connect` succeeded.
};

/// A WebSocket client connection with one I/O thread. Binary messages; pings are answered, and a
/// server that is silent for 60 s is pinged and then given up.
class socket {
public:
  explicit socket(socket_callbacks callbacks);
  ~socket();  ///< As `close`.
  socket(const socket&) = delete;
  socket& operator=(const socket&) = delete;

  /// Connects; at most once for each socket. `url` is "ws://HOST[:PORT][/PATH]" or "wss://...";
  /// `trust` is for the latter.
  /// Errors: `invalid_argument` for the URL or a fingerprint that is none, `io_error` for the file
  /// of authorities, `service_unavailable` when the server is not there, does not answer within
  /// `timeout` or speaks no WebSocket, `untrusted_server` for its certificate.
  [[nodiscard]] expected<void> connect(const std::string& url, std::chrono::milliseconds timeout,
                                       const server_trust& trust = {});

  /// Puts a message into the write queue; thread-safe, never blocks. False when not connected.
  bool send(std::string message);

  /// Bytes of messages that the operating system has not taken yet.
  [[nodiscard]] std::size_t queued_bytes() const;

  /// Waits until at most `limit` bytes are queued. False when that took longer than `patience`;
  /// true at once when the connection is closed.
  [[nodiscard]] bool wait_queue(std::size_t limit, std::chrono::milliseconds patience) const;

  /// Ends the connection at once, without waiting; `on_closed` gets `reason`, before the return
  /// when called from a callback. Thread-safe.
  void abort(error reason);

  /// Sends what is queued and closes (2 s at most), then waits for the I/O thread.
  void close();

  [[nodiscard]] bool connected() const noexcept;

  /// Whether the caller is one of the callbacks.
  [[nodiscard]] bool on_io_thread() const noexcept;

private:
  class impl;
  std::unique_ptr<impl> impl_;
};

}  // namespace tedit::client
