// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/socket.hpp"

#include <utility>  // Asio of Boost 1.74 needs it and does not include it.

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <future>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

#include <boost/asio/connect.hpp>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include "client/server_url.hpp"
#include "tls/stream.hpp"

namespace tedit::client {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using tcp = asio::ip::tcp;
using boost::system::error_code;

constexpr const char* start_remedy = "Start a server with tedit serve.";
constexpr std::chrono::seconds idle_limit{60};
constexpr std::chrono::seconds close_limit{2};

error lost(const error_code& code, const websocket::close_reason& reason) {
  if (code == websocket::error::closed) {
    const std::string why(reason.reason.data(), reason.reason.size());
    return {
      ec::service_unavailable,
      why.empty() ? "the server closed the connection" : "the server closed the connection: " + why,
      "Look into the server's log and connect again.",
      {}};
  }
  if (code == websocket::error::message_too_big || code == websocket::error::buffer_overflow)
    return {
      ec::protocol_error,
      "the server sent a message of more than " + std::to_string(max_incoming_message) + " bytes",
      {},
      {}};
  return {ec::service_unavailable,
          "the connection to the server broke: " + code.message(),
          "Look whether the server still runs and connect again.",
          {}};
}

}  // namespace

class socket::impl {
public:
  explicit impl(socket_callbacks callbacks)
      : callbacks_(std::move(callbacks)),
        resolver_(context_),
        timer_(context_),
        ws_(beast::tcp_stream(context_)) {}

  expected<void> connect(const std::string& url, std::chrono::milliseconds timeout,
                         const server_trust& trust);
  bool send(std::string message);
  std::size_t queued_bytes() const;
  bool wait_queue(std::size_t limit, std::chrono::milliseconds patience) const;
  void abort(error reason);
  void close();

  bool connected() const noexcept { return connected_.load(); }
  bool on_io_thread() const noexcept { return io_thread_.load() == std::this_thread::get_id(); }

private:
  expected<void> prepare_tls();

  // All below run on the I/O thread.
  void run();
  void resolve();
  void connect_tcp(const tcp::resolver::results_type& found);
  void prepare();
  void shake_hands();
  std::optional<error> check_certificate();
  void handshake();
  void opened();
  void not_opened(const std::string& what);
  void not_opened(error why);
  void read();
  void write();
  void written(const error_code& code);
  void begin_close();
  void finish(const error& reason);

  socket_callbacks callbacks_;
  asio::io_context context_{1};
  tcp::resolver resolver_;
  asio::steady_timer timer_;
  websocket::stream<tls::stream<beast::tcp_stream>> ws_;
  websocket::response_type response_;
  beast::flat_buffer incoming_;
  std::string url_;
  server_url address_;
  server_trust trust_;
  std::shared_ptr<const tls::context> tls_;  ///< Null: without TLS.
  std::promise<std::optional<error>> opening_;
  bool opening_answered_ = false;
  bool closing_ = false;        ///< `close` was called.
  bool close_started_ = false;  ///< The close frame is on its way.
  bool finished_ = false;

  std::atomic<bool> connected_{false};
  mutable std::mutex mutex_;
  mutable std::condition_variable drained_;
  std::deque<std::string> queue_;  ///< Guarded; the front is being written.
  std::size_t queued_ = 0;         ///< Guarded; bytes in `queue_`.
  std::thread thread_;
  std::atomic<std::thread::id> io_thread_{};
};

// -- connecting ----------------------------------------------------------------------

expected<void> socket::impl::connect(const std::string& url, std::chrono::milliseconds timeout,
                                     const server_trust& trust) {
  if (thread_.joinable())
    return fail(ec::internal, "a socket connects only once");
  auto parsed = parse_server_url(url);
  if (!parsed)
    return fail(std::move(parsed.error()));
  url_ = url;
  address_ = std::move(*parsed);
  trust_ = trust;
  if (auto ok = prepare_tls(); !ok)
    return ok;
  auto answer = opening_.get_future();
  asio::post(context_, [this] { resolve(); });
  thread_ = std::thread([this] { run(); });
  if (answer.wait_for(timeout) != std::future_status::ready)
    asio::post(context_, [this, timeout] {
      not_opened("no answer within " + std::to_string(timeout.count()) + " ms");
    });
  if (auto failure = answer.get()) {
    thread_.join();
    return fail(std::move(*failure));
  }
  return {};
}

/// Errors: `invalid_argument` for a fingerprint that is none, those of the authorities' file.
expected<void> socket::impl::prepare_tls() {
  if (!address_.secure)
    return {};
  if (!trust_.fingerprint.empty()) {
    const auto given = std::exchange(trust_.fingerprint, tls::read_fingerprint(trust_.fingerprint));
    if (trust_.fingerprint.empty())
      return fail(ec::invalid_argument, "\"" + given + "\" is no SHA-256 of a certificate",
                  "Give 64 hexadecimal digits, with or without colons.");
  }
  auto made = tls::context::of_client(trust_.authority);
  if (!made)
    return fail(made.error());
  tls_ = *std::move(made);
  return {};
}

void socket::impl::run() {
  io_thread_ = std::this_thread::get_id();
  error failure{ec::internal, "the client's I/O thread failed", {}, {}};
  try {
    context_.run();
    return;
  } catch (const std::bad_alloc&) {
    failure = {ec::out_of_memory, "no memory is left for a message of the server", {}, {}};
  } catch (const std::exception& e) {
    failure.message += std::string(": ") + e.what();
  }
  not_opened(failure.message);
  finish(failure);
}

void socket::impl::resolve() {
  resolver_.async_resolve(address_.host, address_.port,
                          [this](const error_code& code, const tcp::resolver::results_type& found) {
                            if (code)
                              return not_opened(code.message());
                            connect_tcp(found);
                          });
}

void socket::impl::connect_tcp(const tcp::resolver::results_type& found) {
  if (opening_answered_)
    return;
  beast::get_lowest_layer(ws_).async_connect(found,
                                             [this](const error_code& code, const tcp::endpoint&) {
                                               if (code)
                                                 return not_opened(code.message());
                                               prepare();
                                             });
}

void socket::impl::prepare() {
  if (opening_answered_)
    return;
  auto& stream = beast::get_lowest_layer(ws_);
  stream.expires_never();
  error_code ignored;
  stream.socket().set_option(tcp::no_delay(true), ignored);
  if (tls_)
    shake_hands();
  else
    handshake();
}

void socket::impl::shake_hands() {
  auto& stream = ws_.next_layer();
  stream.secure(*tls_);
  if (!tls::expect_host(stream.tls(), address_.host))
    return not_opened("\"" + address_.host + "\" is no name of a host");
  stream.async_handshake(asio::ssl::stream_base::client, [this](const error_code& code) {
    if (opening_answered_)
      return;
    if (code.category() == asio::error::get_ssl_category())
      return not_opened(tls::why_refused(static_cast<unsigned>(code.value())));
    if (code)
      return not_opened(code.message());
    if (auto fault = check_certificate())
      return not_opened(std::move(*fault));
    handshake();
  });
}

/// Nothing was said to the server before this.
std::optional<error> socket::impl::check_certificate() {
  const auto shown = tls::certificate_of(ws_.next_layer().tls());
  if (trust_.on_certificate)
    trust_.on_certificate(shown);
  if (!trust_.fingerprint.empty()) {
    if (shown.fingerprint == trust_.fingerprint)
      return std::nullopt;
    return error{ec::untrusted_server,
                 "the server at " + address_.place() + " shows another certificate (SHA-256 " +
                   shown.fingerprint + ") than the one that is trusted (" + trust_.fingerprint +
                   ")",
                 "Ask its operator whether it was exchanged: if so, trust the new one; if not, "
                 "somebody stands between you and the server.",
                 {}};
  }
  if (shown.fault.empty())
    return std::nullopt;
  return error{
    ec::untrusted_server,
    "the certificate of the server at " + address_.place() +
      " is not trusted here: " + shown.fault + "; its SHA-256 is " + shown.fingerprint,
    "Compare that with the fingerprint that \"tedit serve\" prints, and trust it "
    "(--trust FINGERPRINT), or give the certificate of its authority (--server-ca FILE).",
    {}};
}

void socket::impl::handshake() {
  websocket::stream_base::timeout limits = {websocket::stream_base::none(), idle_limit, true};
  ws_.set_option(limits);
  ws_.read_message_max(max_incoming_message);
  ws_.binary(true);
  ws_.auto_fragment(false);
  ws_.write_buffer_bytes(std::size_t{128} << 10);
  ws_.async_handshake(response_, address_.authority, address_.target,
                      [this](const error_code& code) {
                        if (code == websocket::error::upgrade_declined)
                          return not_opened("HTTP " + std::to_string(response_.result_int()) +
                                            " instead of a WebSocket");
                        if (code)
                          return not_opened(code.message());
                        opened();
                      });
}

void socket::impl::opened() {
  if (opening_answered_)
    return;
  opening_answered_ = true;
  connected_ = true;
  opening_.set_value(std::nullopt);
  read();
}

void socket::impl::not_opened(const std::string& what) {
  not_opened(error{ec::service_unavailable,
                   "no server can be reached at " + url_ + ": " + what,
                   start_remedy,
                   {}});
}

void socket::impl::not_opened(error why) {
  if (opening_answered_)
    return;
  opening_answered_ = true;
  opening_.set_value(std::move(why));
  resolver_.cancel();
  beast::get_lowest_layer(ws_).close();
  finished_ = true;
  context_.stop();
}

// -- messages ------------------------------------------------------------------------

void socket::impl::read() {
  ws_.async_read(incoming_, [this](const error_code& code, std::size_t) {
    if (code)
      return finish(closing_
                      ? error{ec::service_unavailable, "this client closed the connection", {}, {}}
                      : lost(code, ws_.reason()));
    const auto data = incoming_.data();
    callbacks_.on_message({static_cast<const char*>(data.data()), data.size()});
    incoming_.consume(incoming_.size());
    if (!finished_)
      read();
  });
}

bool socket::impl::send(std::string message) {
  {
    const std::lock_guard lock(mutex_);
    if (!connected_)
      return false;
    queued_ += message.size();
    queue_.push_back(std::move(message));
    if (queue_.size() > 1)
      return true;
  }
  asio::post(context_, [this] { write(); });
  return true;
}

void socket::impl::write() {
  if (finished_ || close_started_)
    return;
  asio::const_buffer next;
  {
    const std::lock_guard lock(mutex_);
    if (queue_.empty())
      return;
    next = asio::buffer(queue_.front());  // Stays where it is: others are only put behind it.
  }
  ws_.async_write(next, [this](const error_code& code, std::size_t) { written(code); });
}

void socket::impl::written(const error_code& code) {
  if (finished_)
    return;
  if (code)
    return finish(lost(code, ws_.reason()));
  bool more = false;
  {
    const std::lock_guard lock(mutex_);
    queued_ -= queue_.front().size();
    queue_.pop_front();
    more = !queue_.empty();
  }
  drained_.notify_all();
  if (more)
    write();
  else if (closing_)
    begin_close();
}

std::size_t socket::impl::queued_bytes() const {
  const std::lock_guard lock(mutex_);
  return queued_;
}

bool socket::impl::wait_queue(std::size_t limit, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  return drained_.wait_for(lock, patience, [&] { return queued_ <= limit || !connected_; });
}

// -- closing -------------------------------------------------------------------------

void socket::impl::abort(error reason) {
  asio::dispatch(context_, [this, why = std::move(reason)] { finish(why); });
}

void socket::impl::close() {
  if (!thread_.joinable())
    return;
  asio::post(context_, [this] {
    if (finished_)
      return;
    closing_ = true;
    timer_.expires_after(close_limit);
    timer_.async_wait([this](const error_code& code) {
      if (!code)
        finish(
          {ec::service_unavailable, "the server did not close the connection in time", {}, {}});
    });
    if (queued_bytes() == 0)
      begin_close();
  });
  thread_.join();
}

void socket::impl::begin_close() {
  if (close_started_)
    return;
  close_started_ = true;
  ws_.async_close(websocket::close_code::normal, [](const error_code&) {});
}

void socket::impl::finish(const error& reason) {
  if (finished_)
    return;
  finished_ = true;
  {
    const std::lock_guard lock(mutex_);
    connected_ = false;
  }
  drained_.notify_all();
  beast::get_lowest_layer(ws_).close();
  // Beast's idle timer would keep the thread for up to a minute.
  context_.stop();
  callbacks_.on_closed(reason);
}

// -- the class -----------------------------------------------------------------------

socket::socket(socket_callbacks callbacks) : impl_(std::make_unique<impl>(std::move(callbacks))) {}

socket::~socket() {
  impl_->close();
}

expected<void> socket::connect(const std::string& url, std::chrono::milliseconds timeout,
                               const server_trust& trust) {
  return impl_->connect(url, timeout, trust);
}

bool socket::send(std::string message) {
  return impl_->send(std::move(message));
}

std::size_t socket::queued_bytes() const {
  return impl_->queued_bytes();
}

bool socket::wait_queue(std::size_t limit, std::chrono::milliseconds patience) const {
  return impl_->wait_queue(limit, patience);
}

void socket::abort(error reason) {
  impl_->abort(std::move(reason));
}

void socket::close() {
  impl_->close();
}

bool socket::connected() const noexcept {
  return impl_->connected();
}

bool socket::on_io_thread() const noexcept {
  return impl_->on_io_thread();
}

}  // namespace tedit::client
