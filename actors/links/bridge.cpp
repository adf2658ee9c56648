// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/bridge.hpp"

#include <array>
#include <optional>
#include <utility>

#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

namespace tedit::actors {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t buffer_bytes = std::size_t{64} << 10;

/// Asio's owner of OpenSSL's context, which is ours.
asio::ssl::context shared(const tls_context& ours) {
  SSL_CTX_up_ref(ours.native());
  return asio::ssl::context(ours.native());
}

class tls_bridge final : public bridge, public std::enable_shared_from_this<tls_bridge> {
public:
  tls_bridge(tcp_socket socket, std::shared_ptr<const tls_context> context, shaken done)
      : context_(std::move(context)),
        asio_context_(shared(*context_)),
        tls_(std::move(socket), asio_context_),
        link_(tls_.get_executor()),
        limit_(tls_.get_executor()),
        done_(std::move(done)) {}

  void begin(tls_side side, const std::string& host, std::chrono::milliseconds limit) {
    error_code ignored;
    tls_.lowest_layer().set_option(tcp::no_delay(true), ignored);
    limit_.expires_after(limit);
    limit_.async_wait([self = shared_from_this()](error_code stopped) {
      // One that is over may have been on its way when it was cancelled.
      if (!stopped && self->done_)
        self->cut(refusal::silent);
    });
    const bool door = side == tls_side::door;
    if (!door && !expect_host(tls_.native_handle(), host))
      return cut(refusal::wrong_host);
    tls_.async_handshake(
      door ? asio::ssl::stream_base::server : asio::ssl::stream_base::client,
      [self = shared_from_this(), door](error_code problem) { self->shaken_hands(door, problem); });
  }

  void cut(refusal why) override {
    if (!why_)
      why_ = why;
    close();
    finish(tl::unexpected(tls_failure{*why_}));
    if (auto ended = std::exchange(ended_, nullptr))
      ended();
  }

  void carry(unique_fd link, std::function<void()> ended) override {
    ended_ = std::move(ended);
    error_code problem;
    link_.assign(asio::local::stream_protocol(), link.get(), problem);
    if (problem)
      return end();
    static_cast<void>(link.release());
    buffers_ = std::make_unique<std::array<buffer, 2>>();
    pump(link_, tls_, (*buffers_)[0]);
    pump(tls_, link_, (*buffers_)[1]);
  }

private:
  using buffer = std::array<char, buffer_bytes>;

  void shaken_hands(bool door, error_code problem) {
    if (problem)
      return refuse(problem);
    auto peer = peer_of(tls_.native_handle());
    if (!peer)
      return cut(peer.error());
    peer_ = std::move(*peer);
    error_code gone;
    peer_.address = address_text(tls_.lowest_layer().remote_endpoint(gone));
    if (gone)
      return cut(refusal::gone);
    const auto welcomed = [self = shared_from_this()](error_code failed, std::size_t) {
      if (failed)
        return self->refuse(failed);
      if (std::string_view(self->welcome_.data(), self->welcome_.size()) != tls_welcome)
        return self->cut(refusal::not_a_node);
      self->finish(std::move(self->peer_));
    };
    if (!door)
      return asio::async_read(tls_, asio::buffer(welcome_), welcomed);
    tls_welcome.copy(welcome_.data(), welcome_.size());
    asio::async_write(tls_, asio::buffer(welcome_), welcomed);
  }

  void refuse(error_code problem) {
    const bool of_tls = problem.category() == asio::error::get_ssl_category();
    const auto reason = static_cast<unsigned long>(static_cast<unsigned>(problem.value()));
    const auto found = explain_failure(tls_.native_handle(), of_tls ? reason : 0);
    close();
    finish(tl::unexpected(why_ ? tls_failure{*why_} : found));
  }

  void finish(tl::expected<link_peer, tls_failure> result) {
    limit_.cancel();
    if (auto done = std::exchange(done_, nullptr))
      done(std::move(result));
  }

  /// Reads a piece, writes it, reads the next: what the other side does not take is not read.
  template <class From, class To>
  void pump(From& from, To& to, buffer& piece) {
    from.async_read_some(asio::buffer(piece), [self = shared_from_this(), &from, &to, &piece](
                                                error_code problem, std::size_t size) {
      if (problem)
        return self->end();
      asio::async_write(to, asio::buffer(piece.data(), size),
                        [self, &from, &to, &piece](error_code failed, std::size_t) {
                          if (failed)
                            return self->end();
                          self->pump(from, to, piece);
                        });
    });
  }

  void end() {
    close();
    if (auto ended = std::exchange(ended_, nullptr))
      ended();
  }

  void close() {
    error_code ignored;
    limit_.cancel();
    tls_.lowest_layer().close(ignored);
    link_.close(ignored);
  }

  std::shared_ptr<const tls_context> context_;
  asio::ssl::context asio_context_;
  asio::ssl::stream<tcp_socket> tls_;
  asio::local::stream_protocol::socket link_;
  asio::steady_timer limit_;
  shaken done_;
  link_peer peer_;
  std::function<void()> ended_;
  std::optional<refusal> why_;  ///< Why it was cut.
  std::array<char, tls_welcome.size()> welcome_{};
  std::unique_ptr<std::array<buffer, 2>> buffers_;
};

}  // namespace

std::shared_ptr<bridge> bridge::shake_hands(tcp_socket socket,
                                            std::shared_ptr<const tls_context> context,
                                            const std::string& host,
                                            std::chrono::milliseconds limit, shaken done) {
  const auto side = context->side();
  auto made = std::make_shared<tls_bridge>(std::move(socket), std::move(context), std::move(done));
  made->begin(side, host, limit);
  return made;
}

std::string address_text(const tcp::endpoint& where) {
  const bool v6 = where.address().is_v6();
  return (v6 ? "[" : "") + where.address().to_string() + (v6 ? "]:" : ":") +
         std::to_string(where.port());
}

}  // namespace tedit::actors
