// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/support/slow_proxy.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <deque>
#include <string>

namespace tedit::test {

namespace {

using clock = std::chrono::steady_clock;

constexpr auto beat = std::chrono::milliseconds(2);
constexpr std::size_t most_waiting = std::size_t{1} << 20;  ///< Then the sender has to wait.

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

void make_nonblocking(int fd) {
  fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK);
}

}  // namespace

/// One way of a connection.
struct slow_proxy::pipe {
  struct portion {
    clock::time_point due;
    std::string bytes;
  };

  int from = -1;
  int to = -1;
  std::string own_port;  ///< In the first bytes of a request the server wants its own.
  std::string target_port;
  std::deque<portion> waiting;
  std::size_t waiting_bytes = 0;
  clock::time_point free_at;  ///< When the line has passed on what it has.

  /// Takes what the sender has; false when it is gone.
  [[nodiscard]] bool take(const line& quality) {
    std::array<char, 4096> buffer;
    while (waiting_bytes < most_waiting) {
      const auto got = ::recv(from, buffer.data(), buffer.size(), MSG_DONTWAIT);
      if (got < 0)
        return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
      if (got == 0)
        return false;
      const auto size = static_cast<std::uint64_t>(got);
      free_at = std::max(free_at, clock::now()) +
                std::chrono::microseconds(1'000'000 * size / quality.bytes_per_second);
      std::string bytes(buffer.data(), size);
      if (const auto at = bytes.find(own_port); !own_port.empty() && at != bytes.npos) {
        bytes.replace(at, own_port.size(), target_port);
        own_port.clear();
      }
      waiting_bytes += bytes.size();
      waiting.push_back({free_at + quality.delay, std::move(bytes)});
    }
    return true;
  }

  /// Hands on what is due; the bytes handed on, negative when the receiver is gone.
  [[nodiscard]] std::int64_t give() {
    std::int64_t given = 0;
    while (!waiting.empty() && waiting.front().due <= clock::now()) {
      auto& bytes = waiting.front().bytes;
      const auto sent = ::send(to, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      if (sent < 0)
        return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR ? given : -1;
      given += sent;
      waiting_bytes -= static_cast<std::size_t>(sent);
      bytes.erase(0, static_cast<std::size_t>(sent));
      if (bytes.empty())
        waiting.pop_front();
    }
    return given;
  }
};

struct slow_proxy::connection {
  connection(int client, int server, std::uint16_t own, std::uint16_t target) {
    up.from = down.to = client;
    up.to = down.from = server;
    up.own_port = ":" + std::to_string(own);
    up.target_port = ":" + std::to_string(target);
  }
  connection(const connection&) = delete;
  connection& operator=(const connection&) = delete;
  ~connection() {
    ::close(up.from);
    ::close(up.to);
  }

  pipe up;
  pipe down;
};

slow_proxy::slow_proxy(std::uint16_t target, line quality)
    : target_(target),
      quality_(quality),
      listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)),
      connections_(std::make_unique<std::list<connection>>()) {
  auto address = loopback(0);
  socklen_t size = sizeof(address);
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
      ::listen(listener_, 16) == 0 &&
      ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) == 0)
    port_ = ntohs(address.sin_port);
  make_nonblocking(listener_);
  thread_ = std::thread([this] { run(); });
}

slow_proxy::~slow_proxy() {
  ends_ = true;
  thread_.join();
  connections_.reset();
  ::close(listener_);
}

void slow_proxy::cut(bool refuses) {
  refuses_ = refuses;
  cuts_ = true;
}

void slow_proxy::take_connection() {
  const int client = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (client < 0)
    return;
  const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const auto address = loopback(target_);
  if (refuses_ ||
      ::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    ::close(client);
    ::close(server);
    return;
  }
  make_nonblocking(server);
  connections_->emplace_back(client, server, port_, target_);
}

void slow_proxy::run() {
  while (!ends_) {
    std::this_thread::sleep_for(beat);
    take_connection();
    if (cuts_.exchange(false))
      connections_->clear();
    if (stalled_)
      continue;
    for (auto at = connections_->begin(); at != connections_->end();) {
      auto& one = *at;
      const bool open = one.up.take(quality_) && one.down.take(quality_);
      const auto up = one.up.give();
      const auto down = one.down.give();
      if (down > 0)
        delivered_ += static_cast<std::uint64_t>(down);
      const bool drained = one.up.waiting.empty() && one.down.waiting.empty();
      at = up < 0 || down < 0 || (!open && drained) ? connections_->erase(at) : std::next(at);
    }
  }
}

}  // namespace tedit::test
