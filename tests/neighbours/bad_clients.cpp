// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/neighbours/bad_clients.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <deque>
#include <thread>
#include <vector>

#include "client/socket.hpp"
#include "protocol/version.hpp"
#include "tedit/v1/envelope.pb.h"

namespace tedit::test {

namespace {

using namespace std::chrono_literals;

std::uint16_t port_of(const client::connect_options& server) {
  const auto colon = server.url.rfind(':');
  return static_cast<std::uint16_t>(std::stoi(server.url.substr(colon + 1)));
}

v1::ClientMessage hello_of(const client::connect_options& server) {
  v1::ClientMessage message;
  message.set_request_id(1);
  message.mutable_hello()->set_protocol_major(1);
  message.mutable_hello()->set_protocol_minor(protocol::minor_version);
  message.mutable_hello()->set_client("bad neighbour");
  message.mutable_hello()->set_token(server.token);
  return message;
}

v1::ClientMessage open_of(const std::string& document) {
  v1::ClientMessage message;
  message.set_request_id(2);
  message.mutable_open_document()->set_name(document);
  return message;
}

v1::ClientMessage export_of(const std::string& document, std::uint64_t id) {
  v1::ClientMessage message;
  message.set_request_id(id);
  message.mutable_export_file()->set_document(document);
  message.mutable_export_file()->set_format("vtu");
  return message;
}

/// A TCP connection as it is, without anybody who reads.
class bare_socket {
public:
  explicit bare_socket(std::uint16_t port) : handle_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port = htons(port);
    where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int small = 4096;
    ::setsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &small, sizeof(small));
    connected_ = ::connect(handle_, reinterpret_cast<sockaddr*>(&where), sizeof(where)) == 0;
  }
  bare_socket(const bare_socket&) = delete;
  bare_socket& operator=(const bare_socket&) = delete;
  ~bare_socket() { ::close(handle_); }

  [[nodiscard]] bool connected() const { return connected_; }

  void write(const std::string& bytes) const {
    for (std::size_t done = 0; done < bytes.size();) {
      const auto n = ::send(handle_, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
      if (n <= 0)
        return;
      done += static_cast<std::size_t>(n);
    }
  }

  /// Asks for a WebSocket and waits until there is one.
  void upgrade(std::uint16_t port) const {
    write("GET /v1 HTTP/1.1\r\nHost: localhost:" + std::to_string(port) +
          "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
          "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n");
    std::string answer;
    char byte = 0;
    while (answer.find("\r\n\r\n") == std::string::npos && ::recv(handle_, &byte, 1, 0) == 1)
      answer += byte;
  }

  /// One binary frame; the mask is of zeros.
  void send_frame(const v1::ClientMessage& message) const {
    const auto payload = message.SerializeAsString();
    std::string frame = "\x82";
    if (payload.size() < 126) {
      frame += static_cast<char>(0x80 | payload.size());
    } else {
      frame += static_cast<char>(0x80 | 126);
      frame += static_cast<char>(payload.size() >> 8);
      frame += static_cast<char>(payload.size() & 255);
    }
    write(frame + std::string(4, '\0') + payload);
  }

private:
  int handle_;
  bool connected_ = false;
};

class exporter final : public bad_client {
public:
  exporter(const client::connect_options& server, std::string document, int at_once)
      : document_(std::move(document)),
        at_once_(at_once),
        socket_({[this](std::string_view bytes) { received(bytes); }, [](const error&) {}}) {
    value(socket_.connect(server.url, 30s).map([] { return true; }));
    socket_.send(hello_of(server).SerializeAsString());
    socket_.send(open_of(document_).SerializeAsString());
  }

  [[nodiscard]] std::string deeds() const override {
    return std::to_string(files_) + " files exported, " + std::to_string(refused_) + " refused";
  }

private:
  void ask() { socket_.send(export_of(document_, ++last_id_).SerializeAsString()); }

  void received(std::string_view bytes) {
    v1::ServerMessage message;
    if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
      return;
    for (int i = 0; message.has_document_state() && i < at_once_; ++i)
      ask();
    files_ += message.has_file_ready();
    refused_ += message.has_error();
    if (message.has_file_ready())
      ask();
  }

  std::string document_;
  int at_once_;
  std::atomic<std::uint64_t> last_id_{10};
  std::atomic<int> files_{0};
  std::atomic<int> refused_{0};
  client::socket socket_;  ///< Last: it ends before what its callbacks use.
};

class deaf final : public bad_client {
public:
  deaf(const client::connect_options& server, const std::string& document, int exports)
      : socket_(port_of(server)) {
    socket_.upgrade(port_of(server));
    socket_.send_frame(hello_of(server));
    socket_.send_frame(open_of(document));
    std::this_thread::sleep_for(200ms);  // Until it is open.
    for (int i = 0; i < exports; ++i)
      socket_.send_frame(export_of(document, 10 + static_cast<std::uint64_t>(i)));
  }

  [[nodiscard]] std::string deeds() const override { return "never read"; }

private:
  bare_socket socket_;
};

/// Does something again and again on some threads.
class busy : public bad_client {
public:
  ~busy() override { stop(); }

protected:
  template <class Work>
  void start(int threads, Work work) {
    for (int i = 0; i < threads; ++i)
      threads_.emplace_back([this, work] {
        while (!ends_)
          work();
      });
  }

  void stop() {
    ends_ = true;
    for (auto& t : threads_)
      t.join();
    threads_.clear();
  }

  std::atomic<bool> ends_{false};
  std::atomic<int> done_{0};

private:
  std::vector<std::thread> threads_;
};

class half_open final : public busy {
public:
  explicit half_open(const client::connect_options& server) : port_(port_of(server)) {
    start(1, [this] { open_one(); });
  }
  ~half_open() override { stop(); }

  [[nodiscard]] std::string deeds() const override {
    return std::to_string(done_) + " handshakes left half open";
  }

private:
  void open_one() {
    auto one = std::make_unique<bare_socket>(port_);
    if (one->connected()) {
      if (done_ % 3 == 1)
        one->write("GET /v1 HTTP/1.1\r\nHost: local");
      if (done_ % 3 == 2)
        one->upgrade(port_);
      ++done_;
      open_.push_back(std::move(one));
    }
    if (open_.size() > 300)
      open_.pop_front();
    std::this_thread::sleep_for(1ms);
  }

  std::uint16_t port_;
  std::deque<std::unique_ptr<bare_socket>> open_;
};

class guesser final : public busy {
public:
  explicit guesser(client::connect_options server) {
    server.timeout = 10s;
    start(8, [this, server] {
      auto guess = server;
      guess.token = "guess " + std::to_string(++done_);
      answers_ += !client::client::connect(guess, {}).has_value();
    });
  }
  ~guesser() override { stop(); }

  [[nodiscard]] std::string deeds() const override {
    return std::to_string(answers_) + " guesses answered";
  }

private:
  std::atomic<int> answers_{0};
};

}  // namespace

std::unique_ptr<bad_client> make_exporter(const client::connect_options& server,
                                          const std::string& document, int at_once) {
  return std::make_unique<exporter>(server, document, at_once);
}

std::unique_ptr<bad_client> make_deaf(const client::connect_options& server,
                                      const std::string& document, int exports) {
  return std::make_unique<deaf>(server, document, exports);
}

std::unique_ptr<bad_client> make_half_open(const client::connect_options& server) {
  return std::make_unique<half_open>(server);
}

std::unique_ptr<bad_client> make_guesser(const client::connect_options& server) {
  return std::make_unique<guesser>(server);
}

}  // namespace tedit::test
