// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <list>
#include <memory>
#include <thread>

namespace tedit::test {

/// A bad line between a client and a server on this machine: it hands on what it is given later and
/// in small portions, holds everything up, or breaks. One thread; all members may be called from
/// any.
class slow_proxy {
public:
  struct line {
    std::chrono::milliseconds delay{100};      ///< Each way.
    std::uint64_t bytes_per_second = 200'000;  ///< Each way and connection.
  };

  /// Listens on a free port of 127.0.0.1 and hands on to `target` there.
  slow_proxy(std::uint16_t target, line quality);
  slow_proxy(const slow_proxy&) = delete;
  slow_proxy& operator=(const slow_proxy&) = delete;
  ~slow_proxy();

  /// 0 when it could not listen.
  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }

  /// Nothing moves until `stall(false)`; connections stay.
  void stall(bool on) { stalled_ = on; }
  /// Breaks all connections; while `refuses`, new ones are broken at once.
  void cut(bool refuses);
  /// Takes new connections again.
  void mend() { refuses_ = false; }

  /// Bytes that reached a client.
  [[nodiscard]] std::uint64_t delivered() const noexcept { return delivered_; }

private:
  struct pipe;
  struct connection;

  void run();
  void take_connection();

  std::uint16_t target_;
  line quality_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::atomic<bool> ends_{false};
  std::atomic<bool> stalled_{false};
  std::atomic<bool> refuses_{false};
  std::atomic<bool> cuts_{false};
  std::atomic<std::uint64_t> delivered_{0};
  std::unique_ptr<std::list<connection>> connections_;
  std::thread thread_;
};

}  // namespace tedit::test
