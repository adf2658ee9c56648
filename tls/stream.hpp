// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>  // Boost.Asio 1.74 uses it without including it.

#include <array>
#include <memory>
#include <optional>
#include <type_traits>

#include <boost/asio/associated_executor.hpp>
#include <boost/asio/bind_executor.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/websocket/teardown.hpp>

#include "tls/context.hpp"

namespace tedit::tls {

/// Who hears how many bytes went, whatever type he has: what lies below is compiled once for all,
/// and not anew for each step of HTTP and of WebSocket. One allocation an operation, which is
/// given back before he hears, as Boost.Asio wants it.
class io_handler {
public:
  template <class Handler>
  requires(!std::is_same_v<Handler, io_handler>) explicit io_handler(Handler handler)
      : held_(new held<Handler>(std::move(handler))) {}
  io_handler(io_handler&&) noexcept = default;
  io_handler& operator=(io_handler&&) noexcept = default;

  void operator()(boost::system::error_code problem, std::size_t bytes) {
    held_.release()->end(problem, bytes);
  }

private:
  struct any {
    virtual ~any() = default;
    /// Ends its own life first.
    virtual void end(boost::system::error_code problem, std::size_t bytes) = 0;
  };

  template <class Handler>
  struct held final : any {
    explicit held(Handler h) : handler(std::move(h)) {}

    void end(boost::system::error_code problem, std::size_t bytes) override {
      auto last = std::move(handler);
      delete this;
      last(problem, bytes);
    }

    Handler handler;
  };

  std::unique_ptr<any> held_;
};

/// The first of some buffers, in one type: reading and writing "some" may stop there.
template <class Buffer>
class first_buffers {
public:
  template <class Buffers>
  explicit first_buffers(const Buffers& all) {
    const auto end = boost::asio::buffer_sequence_end(all);
    for (auto at = boost::asio::buffer_sequence_begin(all); at != end && count_ < kept_.size();
         ++at)
      if (const Buffer one = *at; one.size() > 0)
        kept_[count_++] = one;
  }

  using value_type = Buffer;
  using const_iterator = const Buffer*;
  [[nodiscard]] const_iterator begin() const { return kept_.data(); }
  [[nodiscard]] const_iterator end() const { return kept_.data() + count_; }

private:
  std::array<Buffer, 8> kept_;
  std::size_t count_ = 0;
};

/// A TCP stream that speaks TLS or does not, which is said when it is used and not when it is
/// compiled: what stands on it, as WebSocket, is compiled once for both. `Tcp` is a stream of
/// Beast. Without TLS each call costs a branch and an allocation more than `Tcp` alone.
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

  /// Back to no TLS, after a handshake that failed: to say why.
  void give_up_tls() { parts_->tls.reset(); }

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
    const first_buffers<boost::asio::mutable_buffer> some(into);
    auto then = forgotten(std::forward<Handler>(handler));
    if (parts_->tls)
      parts_->tls->async_read_some(some, std::move(then));
    else
      parts_->tcp.async_read_some(some, std::move(then));
  }

  template <class Buffers, class Handler>
  void async_write_some(const Buffers& from, Handler&& handler) {
    const first_buffers<boost::asio::const_buffer> some(from);
    auto then = forgotten(std::forward<Handler>(handler));
    if (parts_->tls)
      parts_->tls->async_write_some(some, std::move(then));
    else
      parts_->tcp.async_write_some(some, std::move(then));
  }

private:
  struct parts {
    explicit parts(Tcp stream) : tcp(std::move(stream)) {}

    Tcp tcp;
    std::optional<boost::asio::ssl::stream<Tcp&>> tls;
  };

  /// Called where the handler wants to be called.
  template <class Handler>
  auto forgotten(Handler&& handler) {
    const auto where = boost::asio::get_associated_executor(handler, get_executor());
    return boost::asio::bind_executor(
      where, io_handler(std::decay_t<Handler>(std::forward<Handler>(handler))));
  }

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
