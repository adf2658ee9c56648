// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>

#include "base/unique_fd.hpp"

/// Peers that keep to nothing: plain sockets, and OpenSSL with whatever settings. They block, with
/// a limit of some seconds for each read and write.
namespace tedit::test {

/// OpenSSL writes to the strangers' sockets by itself, which raises SIGPIPE; doors and dials do
/// not.
class pipe_signal_ignored {
public:
  pipe_signal_ignored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  pipe_signal_ignored(const pipe_signal_ignored&) = delete;
  pipe_signal_ignored& operator=(const pipe_signal_ignored&) = delete;
  ~pipe_signal_ignored() { std::signal(SIGPIPE, before_); }

private:
  void (*before_)(int);
};

/// A TCP connection to this machine; no descriptor when there is none.
[[nodiscard]] unique_fd plain_connection(std::uint16_t port);

/// Whether the other side ends the connection within a generous time; what it says is read.
[[nodiscard]] bool is_ended_by_peer(int fd);

struct tls_settings {
  std::filesystem::path identity = {};    ///< A node's folder; empty: no certificate.
  int version = 0x0304;                   ///< The only one; 0x0303 is TLS 1.2.
  std::string protocol = "tedit-node/1";  ///< ALPN; empty: none.
};

/// Shakes hands with a door and reads what it says first: that, or empty when it said nothing and
/// ended the connection, by whatever way.
[[nodiscard]] std::string first_words(std::uint16_t port, const tls_settings& settings);

/// A TLS server of these settings that says `words` to whoever comes, on a port and thread of its
/// own.
class tls_stranger {
public:
  explicit tls_stranger(tls_settings settings, std::string words = "tedit-1\n");
  tls_stranger(const tls_stranger&) = delete;
  tls_stranger& operator=(const tls_stranger&) = delete;
  ~tls_stranger();

  [[nodiscard]] std::uint16_t port() const { return port_; }

private:
  void serve();

  pipe_signal_ignored ignored_;
  tls_settings settings_;
  std::string words_;
  unique_fd listener_;
  std::uint16_t port_ = 0;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

/// A listening TCP socket of this machine that nobody takes connections from.
struct silent_listener {
  unique_fd socket;
  std::uint16_t port = 0;
};
[[nodiscard]] silent_listener listen_silently();

}  // namespace tedit::test
