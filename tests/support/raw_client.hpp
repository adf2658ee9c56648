// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "client/socket.hpp"
#include "protocol/version.hpp"
#include "tedit/v1/envelope.pb.h"

namespace tedit::test {

/// What servers of tests ask for.
inline constexpr auto server_token = "secret-of-the-test";

/// A connection on which a test says whatever it likes, also what no client should.
class raw_client {
public:
  explicit raw_client(const std::string& url)
      : socket_({[this](std::string_view bytes) { received(bytes); },
                 [this](const error& why) { closed(why); }}) {
    if (auto ok = socket_.connect(url, limit); !ok)
      throw std::runtime_error(render(ok.error()));
  }

  /// Introduces itself; the answer.
  v1::ServerMessage hello(const std::string& token, std::uint32_t minor = protocol::minor_version,
                          const std::string& name = "test") {
    v1::ClientMessage message;
    auto* hello = message.mutable_hello();
    hello->set_protocol_major(protocol::major_version);
    hello->set_protocol_minor(minor);
    hello->set_client(name);
    hello->set_token(token);
    return ask(std::move(message));
  }

  void send(const v1::ClientMessage& message) { socket_.send(message.SerializeAsString()); }

  /// Sends with the next request id, which is returned.
  std::uint64_t start(v1::ClientMessage message) {
    message.set_request_id(++last_id_);
    send(message);
    return last_id_;
  }

  /// The first message that fits, which is taken away. Throws when none comes.
  v1::ServerMessage wait(const std::function<bool(const v1::ServerMessage&)>& fits) {
    std::unique_lock lock(mutex_);
    std::optional<v1::ServerMessage> found;
    const auto look = [&] {
      for (auto m = messages_.begin(); m != messages_.end(); ++m)
        if (fits(*m)) {
          found = std::move(*m);
          messages_.erase(m);
          return true;
        }
      return !closed_.empty();
    };
    changed_.wait_for(lock, limit, look);
    if (!found)
      throw std::runtime_error(closed_.empty() ? "no answer came" : "closed: " + closed_);
    return std::move(*found);
  }

  /// Whether such a message has come.
  bool has(const std::function<bool(const v1::ServerMessage&)>& fits) {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(messages_, fits);
  }

  /// The answer to a request; progress passes by.
  v1::ServerMessage answer(std::uint64_t id) {
    return wait(
      [=](const v1::ServerMessage& m) { return m.request_id() == id && !m.has_progress(); });
  }

  v1::ServerMessage ask(v1::ClientMessage message) { return answer(start(std::move(message))); }

  /// The bytes of a stream that was announced, once all of its chunks have come.
  std::string stream(const v1::Stream& announced) {
    std::string bytes;
    while (bytes.size() < announced.bytes())
      bytes += wait([&](const v1::ServerMessage& m) {
                 return m.has_chunk() && m.chunk().stream() == announced.stream();
               })
                 .chunk()
                 .data();
    return bytes;
  }

  /// Why the connection ended; waits for it.
  std::string end() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, limit, [&] { return !closed_.empty(); });
    return closed_;
  }

  [[nodiscard]] bool connected() const { return socket_.connected(); }

private:
  void received(std::string_view bytes) {
    v1::ServerMessage message;
    const bool good = message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
    const std::lock_guard lock(mutex_);
    if (good)
      messages_.push_back(std::move(message));
    else
      closed_ = "a message that cannot be parsed came";
    changed_.notify_all();
  }

  void closed(const error& why) {
    const std::lock_guard lock(mutex_);
    if (closed_.empty())
      closed_ = render(why);
    changed_.notify_all();
  }

  static constexpr std::chrono::seconds limit{60};

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<v1::ServerMessage> messages_;
  std::string closed_;
  std::uint64_t last_id_ = 0;
  client::socket socket_;  ///< Last: it ends before what its callbacks use.
};

}  // namespace tedit::test
