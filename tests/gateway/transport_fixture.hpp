// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>  // Boost.Asio 1.74 uses it without including it.

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "actors/gateway/transport.hpp"
#include "certs/authority.hpp"
#include "tests/support/scratch.hpp"
#include "tls/stream.hpp"

/// A transport with clients whose calls block.
namespace tedit::gateway::test {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;
using tcp = net::ip::tcp;
using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr auto patience = 20s;  ///< For what must happen; reached only by a failing test.
constexpr std::size_t mib = std::size_t{1} << 20;

inline std::string noise(std::size_t size) {
  std::string bytes(size, '\0');
  for (std::size_t i = 0; i < size; ++i)
    bytes[i] = static_cast<char>(i * 2654435761u >> 20);
  return bytes;
}

inline frame make_frame(std::size_t size, char fill = 'x') {
  return std::make_shared<const std::string>(size, fill);
}

/// What the handlers saw, for the test's thread.
struct log {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::shared_ptr<connection>> opened;
  std::vector<std::string> closed;
  std::vector<int> drained;
  std::vector<std::size_t> kept;
  std::vector<std::size_t> backlogs;

  template <class T>
  void update(std::vector<T>& list, std::type_identity_t<T> entry) {
    const std::lock_guard lock(mutex);
    list.push_back(std::move(entry));
    changed.notify_all();
  }

  /// The entry at `index` once it is there.
  template <class T>
  T wait(const std::vector<T>& list, std::size_t index = 0) {
    std::unique_lock lock(mutex);
    EXPECT_TRUE(changed.wait_for(lock, patience, [&] { return list.size() > index; }));
    return list.at(index);
  }
};

/// Takes the first message as the hello and sends every message back; "throw" throws.
class echo final : public connection_handler {
public:
  echo(std::shared_ptr<connection> c, std::shared_ptr<log> l)
      : connection_(std::move(c)), log_(std::move(l)) {}

  void on_message(std::string bytes) override {
    if (bytes.starts_with("keep"))
      return log_->update(log_->kept, bytes.size());  // Until the test says that it is handled.
    connection_->handled(bytes.size());
    if (bytes == "throw")
      throw std::runtime_error("a test");
    if (bytes != "stranger")
      connection_->authenticated();
    connection_->send(std::make_shared<const std::string>(std::move(bytes)));
  }
  void on_drained() override { log_->update(log_->drained, 1); }
  frame on_backlog(std::size_t waiting, std::size_t most, std::chrono::milliseconds rest) override {
    log_->update(log_->backlogs, waiting);
    return std::make_shared<const std::string>("more than " + std::to_string(most) + " for " +
                                               std::to_string(rest.count()) + " ms");
  }
  void on_closed(const std::string& reason) override { log_->update(log_->closed, reason); }

private:
  std::shared_ptr<connection> connection_;
  std::shared_ptr<log> log_;
};

/// Polls what has no event of its own.
template <class Condition>
[[nodiscard]] bool eventually(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!condition() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(2ms);
  return std::chrono::steady_clock::now() < end;
}

/// An authority and a server's certificate for this machine, made once for a test program.
class server_certificates {
public:
  static const server_certificates& get() {
    static const server_certificates made;
    return made;
  }

  [[nodiscard]] std::filesystem::path authority() const { return folder_.path() / "ca"; }
  [[nodiscard]] std::filesystem::path folder() const { return folder_.path() / "hall"; }
  [[nodiscard]] const tls::context& trusted() const { return *context_; }

private:
  server_certificates() {
    tedit::test::value(certs::init(authority()));
    tedit::test::value(certs::issue(
      authority(), {certs::role::server, "hall", {"127.0.0.1", "localhost"}}, folder()));
    context_ =
      tedit::test::value(tls::context::of_client(authority() / certs::authority_certificate_file));
  }

  tedit::test::scratch_folder folder_;
  std::shared_ptr<const tls::context> context_;
};

/// One client with blocking calls, each of which ends after `patience`.
class client {
public:
  /// With TLS when `how` says how.
  explicit client(std::uint16_t port, int receive_buffer = 0, const tls::context* how = nullptr) {
    auto& socket = beast::get_lowest_layer(ws_).socket();
    socket.open(tcp::v4());
    if (receive_buffer > 0)
      socket.set_option(net::socket_base::receive_buffer_size(receive_buffer));
    socket.connect({net::ip::address_v4::loopback(), port});
    ws_.read_message_max(64 * mib);
    ws_.binary(true);
    if (how == nullptr)
      return;
    ws_.next_layer().secure(*how);
    EXPECT_TRUE(tls::expect_host(ws_.next_layer().tls(), "127.0.0.1"));
    shaken_ = run([&](auto done) {
      ws_.next_layer().async_handshake(net::ssl::stream_base::client, std::move(done));
    });
    if (!shaken_) {
      EXPECT_EQ(tls::certificate_of(ws_.next_layer().tls()).fault, "");
    }
  }

  /// What became of the TLS handshake.
  [[nodiscard]] error_code shaken() const { return shaken_; }

  /// The HTTP status of the answer.
  int upgrade(const std::string& host, const std::string& origin = {},
              const std::string& path = "/v1") {
    ws_.set_option(websocket::stream_base::decorator([&](websocket::request_type& r) {
      if (!origin.empty())
        r.set(http::field::origin, origin);
    }));
    websocket::response_type response;
    run([&](auto done) { ws_.async_handshake(response, host, path, std::move(done)); });
    return static_cast<int>(response.result_int());
  }

  error_code write(const std::string& bytes) {
    return run([&](auto done) { ws_.async_write(net::buffer(bytes), std::move(done)); });
  }

  /// The next message, or nothing once the connection is over.
  std::optional<std::string> read() {
    std::string bytes;
    auto buffer = net::dynamic_buffer(bytes);
    problem_ = run([&](auto done) { ws_.async_read(buffer, std::move(done)); });
    return problem_ ? std::nullopt : std::optional(std::move(bytes));
  }

  std::optional<std::string> round_trip(const std::string& bytes) {
    return write(bytes) ? std::nullopt : read();
  }

  /// Reads to the end; the close code that came, 0 when the connection broke without one.
  int close_code() {
    while (read()) {
    }
    return problem_ == websocket::error::closed ? ws_.reason().code : 0;
  }

  /// Sends bytes as they are and reads until the server closes.
  std::string raw(const std::string& bytes) {
    auto& stream = ws_.next_layer();
    run([&](auto done) { net::async_write(stream, net::buffer(bytes), std::move(done)); });
    std::string answer;
    run([&](auto done) { net::async_read(stream, net::dynamic_buffer(answer), std::move(done)); });
    return answer;
  }

  websocket::stream<tls::stream<beast::tcp_stream>>& stream() { return ws_; }

  template <class Start>
  error_code run(Start start) {
    error_code result = net::error::timed_out;
    io_.restart();
    start([&](error_code e, auto...) { result = e; });
    io_.run_for(patience);
    if (!io_.stopped()) {
      ADD_FAILURE() << "the server did not answer";
      beast::get_lowest_layer(ws_).close();
      io_.run();
    }
    return result;
  }

private:
  net::io_context io_{1};
  websocket::stream<tls::stream<beast::tcp_stream>> ws_{beast::tcp_stream(io_)};
  error_code problem_;
  error_code shaken_;
};

/// With TLS or without, as the parameter says.
class transport_fixture : public ::testing::TestWithParam<bool> {
protected:
  void start() {
    if (GetParam())
      options.certificates = server_certificates::get().folder();
    start_with_options();
  }

  void start_with_options() {
    options.pages["/healthz"] = [this](const page_request& asked) {
      last_asked = asked;
      return page_answer{well ? 200U : 503U, R"({"ok":true})"};
    };
    options.accept = [l = seen](std::shared_ptr<connection> c) {
      l->update(l->opened, c);
      return std::make_unique<echo>(std::move(c), l);
    };
    auto started = transport::start(options);
    ASSERT_TRUE(started) << render(started.error());
    server = *std::move(started);
    host = "localhost:" + std::to_string(server->port());
  }

  std::unique_ptr<client> connect(int receive_buffer = 0) {
    auto c = std::make_unique<client>(server->port(), receive_buffer, trusted());
    EXPECT_EQ(c->upgrade(host), 101);
    return c;
  }

  /// A client that has said its hello.
  std::unique_ptr<client> connect_known(int receive_buffer = 0) {
    auto c = connect(receive_buffer);
    EXPECT_EQ(c->round_trip("hello"), "hello");
    return c;
  }

  std::string ask(const std::string& first_line, const std::string& more = {}) {
    return fresh().raw(first_line + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n");
  }

  /// A client that has said nothing yet, but for TLS's own words.
  [[nodiscard]] client fresh() const { return client(server->port(), 0, trusted()); }
  [[nodiscard]] static const tls::context* trusted() {
    return GetParam() ? &server_certificates::get().trusted() : nullptr;
  }

  transport_options options;
  std::shared_ptr<log> seen = std::make_shared<log>();
  std::unique_ptr<transport> server;
  std::string host;
  std::atomic<bool> well = true;
  page_request last_asked;  ///< Read after its answer.
};

inline std::string with_or_without(const ::testing::TestParamInfo<bool>& which) {
  return which.param ? "tls" : "plain";
}

}  // namespace tedit::gateway::test
