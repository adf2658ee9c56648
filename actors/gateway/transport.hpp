// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"

/// The server side of WebSocket and of a little plain HTTP. It knows nothing of what the messages
/// mean; it moves bytes, keeps the limits and gets rid of clients that break them.
namespace tedit::gateway {

/// The bytes of one message; shared, so that one encoding serves many clients.
using frame = std::shared_ptr<const std::string>;

/// One WebSocket connection as the rest of the gateway sees it. All members may be called from any
/// thread and at any time, also after the connection or the whole transport is gone: then they do
/// nothing.
class connection {
public:
  connection() = default;
  connection(const connection&) = delete;
  connection& operator=(const connection&) = delete;
  virtual ~connection() = default;

  /// Queues one binary message; returns at once. The queue is not cut off at `max_queue`: whoever
  /// sends much looks at `queued_bytes` and waits for `on_drained`.
  virtual void send(frame bytes) = 0;

  /// Bytes accepted by `send` and not yet handed to the operating system.
  [[nodiscard]] virtual std::size_t queued_bytes() const = 0;

  /// Says that the client has proved who it is: ends the hello timeout, raises the message limit
  /// from `max_first_message` to `max_message` and takes one of `max_connections` places, or closes
  /// with 1013 when none is left. Call it before the reply to the hello is sent.
  virtual void authenticated() = 0;

  /// Says that so many bytes of messages have been dealt with. While more than `max_unhandled` were
  /// handed over and are not, nothing is read: a client that is quicker than its handler waits.
  virtual void handled(std::size_t bytes) = 0;

  /// Closes after what is queued. `code` is a WebSocket close code (1000, 1008, 4000-4999, ...);
  /// `reason` is cut to 123 bytes. Messages that arrive from now on are dropped.
  virtual void close(std::uint16_t code, std::string reason) = 0;

  /// The client's "address:port".
  [[nodiscard]] virtual std::string peer() const = 0;
};

/// Callbacks of one connection, called from the I/O thread, never two at once for one connection.
/// They must not block: all other connections wait. An exception closes the connection with 1011.
class connection_handler {
public:
  connection_handler() = default;
  connection_handler(const connection_handler&) = delete;
  connection_handler& operator=(const connection_handler&) = delete;
  virtual ~connection_handler() = default;

  /// One whole binary message.
  virtual void on_message(std::string bytes) = 0;

  /// The queue fell below `low_water` after having been at or above it.
  virtual void on_drained() = 0;

  /// More than `most` bytes wait, and the connection will be closed after `rest` unless the client
  /// takes some. What this returns, if anything, is sent before all that waits.
  virtual frame on_backlog(std::size_t waiting, std::size_t most, std::chrono::milliseconds rest) {
    static_cast<void>(waiting);
    static_cast<void>(most);
    static_cast<void>(rest);
    return nullptr;
  }

  /// The connection is gone; `reason` is a sentence for the log, led by the close code if this side
  /// closed. The last call: the handler is destroyed afterwards.
  virtual void on_closed(const std::string& reason) = 0;
};

/// What one client may use up. Sizes in bytes.
struct transport_limits {
  std::size_t max_message = std::size_t{16} << 20;       ///< Inbound, else closed with 1009.
  std::size_t max_first_message = std::size_t{4} << 10;  ///< The same until `authenticated`.
  std::size_t max_unhandled = std::size_t{32} << 20;     ///< Inbound, see `connection::handled`.
  std::size_t max_queue = std::size_t{32} << 20;         ///< Outbound, the newest message included.
  std::size_t low_water = std::size_t{1} << 20;          ///< See `on_drained`.
  std::size_t max_connections = 256;  ///< Of clients that are `authenticated`; then 503.
  std::size_t max_per_address = 64;   ///< The same for one client address.
  /// Sockets of all others, HTTP included. Above it the oldest of the address that has most of them
  /// gives way to the newcomer: an honest client needs its place for moments only.
  std::size_t max_strangers = 128;
  std::size_t max_header = std::size_t{8} << 10;  ///< HTTP request header; else 431.
  std::chrono::milliseconds handshake_timeout{
    5'000};                                        ///< From TCP accept to HTTP reply, TLS included.
  std::chrono::milliseconds hello_timeout{5'000};  ///< Until `authenticated`, else 1008.
  std::chrono::milliseconds slow_client{10'000};   ///< Time above `max_queue`; then 1013.
  std::chrono::milliseconds ping_after{15'000};    ///< Silence before a ping.
  std::chrono::milliseconds idle_timeout{45'000};  ///< Silence before the client is dropped.
  std::chrono::milliseconds close_timeout{1'000};  ///< Wait for the client's side of a close.
};

/// Who asks for a page.
struct page_request {
  bool local = false;  ///< From this machine.
  std::string bearer;  ///< The token of "Authorization: Bearer TOKEN"; empty: none.
};

struct page_answer {
  unsigned status = 200;
  std::string body;
  std::string type = "application/json";
};

struct transport_options {
  std::string address = "127.0.0.1";         ///< An IP address, or "localhost".
  std::uint16_t port = 0;                    ///< 0: any free port.
  std::vector<std::string> allowed_origins;  ///< See `origin_allowed`.
  std::vector<std::string> allowed_hosts;    ///< See `host_allowed`; `address` need not be named.
  /// Folder of `tls::server_identity`, whose hosts are allowed, too. Empty: without TLS.
  std::filesystem::path certificates;
  transport_limits limits;

  /// What GET answers, by path: "/healthz". Called from the I/O thread; must not block.
  std::map<std::string, std::function<page_answer(const page_request&)>> pages;

  /// Makes the handler of a new connection. Called from the I/O thread before any message; null
  /// refuses the connection (closed with 1013).
  std::function<std::unique_ptr<connection_handler>(std::shared_ptr<connection>)> accept;
};

/// Listens on one address and port with one I/O thread, with TLS 1.3 or without. WebSocket is at
/// /v1, without compression, binary messages only (text is closed with 1003); GET of a page what
/// that says; other paths 404, other methods 405, a foreign Origin or Host 403, too many
/// connections 503. Connections that are not `authenticated` have places of their own, so that they
/// take none from clients.
class transport {
public:
  /// Binds, listens and starts the thread. Errors: `invalid_argument` for an address that is none
  /// or a missing `accept`, `service_unavailable` when the port cannot be had; those of
  /// `tls::server_identity::load`.
  [[nodiscard]] static expected<std::unique_ptr<transport>> start(transport_options options);

  transport(const transport&) = delete;
  transport& operator=(const transport&) = delete;
  ~transport();  ///< Stops.

  /// The port listened on, also when 0 was asked for.
  [[nodiscard]] std::uint16_t port() const;

  /// SHA-256 of the certificate that it showed first; empty without TLS.
  [[nodiscard]] std::string fingerprint() const;

  /// WebSocket connections that are open now.
  [[nodiscard]] std::size_t connections() const;

  /// Stops listening, closes every connection with 1001 (what is queued is dropped) and joins the
  /// thread; every handler has had its `on_closed` when it returns. Takes up to `close_timeout` and
  /// a quarter of a second when clients do not answer. Not to be called from a handler.
  void stop();

private:
  struct impl;
  explicit transport(std::unique_ptr<impl> state);

  std::unique_ptr<impl> impl_;
};

}  // namespace tedit::gateway
