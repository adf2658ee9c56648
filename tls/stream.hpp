// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>  // Boost.Asio 1.74 uses it without including it.

#include <memory>
#include <optional>

#include <boost/asio/associated_executor.hpp>
#include <boost/asio/bind_executor.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/websocket/teardown.hpp>

#include "tls/context.hpp"

namespace tedit::tls {

/// A TCP stream that speaks TLS or does not, which is said when it is used and not when it is
/// compiled: what stands on it, as WebSocket, is compiled once for both. `Tcp` is a stream of
/// Beast. Without TLS each call costs one branch more than `Tcp` alone.
template <class Tcp>
class stream {
public:
  using next_layer_type = Tcp;
  using executor_type = typename Tcp::executor_type;

  explicit stream(Tcp tcp) : parts_(std::make_unique<parts>(std::move(tcp))) {}

  [[nodiscard]] Tcp& next_layer() noexcept { return parts_->tcp; }
  [[nodiscard]] const Tcp& next_layer() const noexcept { return parts_->tcp; }
  [[nodiscard]] executor_type get_executor() noexcept { return parts_->tcp.get_executor(); }

  /// From here on TLS is spoken; nothing was read or written before.
  void secure(const context& how) {
    auto owner = how.for_asio();
    parts_->tls.emplace(parts_->tcp, owner);
  }

  /// OpenSSL's connection; null when there is no TLS.
  [[nodiscard]] ssl_st* tls() noexcept {
    return parts_->tls ? parts_->tls->native_handle() : nullptr;
  }

  /// @pre `secure` was called. `handler` takes an error code.
  template <class Handler>
  void async_handshake(boost::asio::ssl::stream_base::handshake_type side, Handler&& handler) {
    parts_->tls->async_handshake(side, std::forward<Handler>(handler));
  }

  /// Tells the other side that nothing more comes, and waits until it says so, too.
  /// @pre `secure` was called. `handler` takes an error code.
  template <class Handler>
  void async_shutdown(Handler&& handler) {
    parts_->tls->async_shutdown(std::forward<Handler>(handler));
  }

  template <class Buffers, class Handler>
  void async_read_some(const Buffers& into, Handler&& handler) {
    if (parts_->tls)
      parts_->tls->async_read_some(into, std::forward<Handler>(handler));
    else
      parts_->tcp.async_read_some(into, std::forward<Handler>(handler));
  }

  template <class Buffers, class Handler>
  void async_write_some(const Buffers& from, Handler&& handler) {
    if (parts_->tls)
      parts_->tls->async_write_some(from, std::forward<Handler>(handler));
    else
      parts_->tcp.async_write_some(from, std::forward<Handler>(handler));
  }

private:
  struct parts {
    explicit parts(Tcp stream) : tcp(std::move(stream)) {}

    Tcp tcp;
    std::optional<boost::asio::ssl::stream<Tcp&>> tls;
  };

  std::unique_ptr<parts> parts_;  ///< In a place of their own: `tls` refers to `tcp`.
};

/// How WebSocket ends such a stream. How TLS ended says nothing beside why WebSocket did.
template <class Tcp, class Handler>
void async_teardown(boost::beast::role_type role, stream<Tcp>& ended, Handler&& handler) {
  namespace asio = boost::asio;
  if (ended.tls() != nullptr) {
    const auto where = asio::get_associated_executor(handler, ended.get_executor());
    return ended.async_shutdown(asio::bind_executor(
      where, [then = std::forward<Handler>(handler)](boost::system::error_code) mutable {
        then(boost::system::error_code());
      }));
  }
  using boost::beast::websocket::async_teardown;
  async_teardown(role, ended.next_layer(), std::forward<Handler>(handler));
}

}  // namespace tedit::tls
