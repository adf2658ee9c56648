// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "actors/links/knock_limits.hpp"
#include "actors/links/refusal.hpp"
#include "base/error.hpp"
#include "base/unique_fd.hpp"

namespace tedit::actors {

struct door_options {
  /// What "tedit certs issue --role server" made. Files that change are read anew, for whoever
  /// comes then.
  std::filesystem::path identity;
  /// The list of revoked certificates; empty: `crl.pem` in `identity`. On the authority's own
  /// machine best the one in its folder.
  std::filesystem::path revoked;
  std::string address = "127.0.0.1";  ///< Of this machine; "0.0.0.0" and "::" are all.
  std::uint16_t port = 0;             ///< 0: any that is free.
  std::set<certs::role> roles = {certs::role::modeling, certs::role::optimizer, certs::role::solver,
                                 certs::role::observer};

  /// Gets each new link: `end` is for `serve_link`, closing it ends the connection. Called on the
  /// door's thread, which must not be blocked.
  std::function<void(unique_fd end, link_peer who)> accept;

  std::chrono::milliseconds handshake_limit = std::chrono::seconds(5);
  /// Connections that have not said who they are; beyond, the oldest of the address with the most
  /// of them goes, so that who holds many open shuts out nobody.
  std::size_t most_handshakes = 256;
  std::size_t most_handshakes_per_address = 64;
  std::size_t most_links = 256;
  /// Handshakes that failed: what stands in the way of one (no certificate, another authority, an
  /// ended or revoked one, no TLS) counts; who leaves or is silent does not, so that neither a look
  /// whether the port is open nor a neighbour behind the same router shuts a node out.
  knock_rates knocks;
  /// How often it is looked whether certificates of those that are linked still hold.
  std::chrono::milliseconds look_every = std::chrono::minutes(1);
};

/// Listens for nodes on other machines and makes links of those that show a certificate of this
/// node's authority: mutual TLS 1.3. Nobody else gets a byte through, and nobody who is slow or
/// silent keeps another waiting: all of it is one thread, which blocks nowhere.
///
/// What ends a link cuts its connection, and the other way round; a certificate that ends or is
/// revoked meanwhile is cut at the next look. Who is refused is counted by reason and logged, one
/// line a second at most.
/// Cost: a handshake a millisecond of the door's thread; a link 128 KiB of buffers and what OpenSSL
/// keeps.
class door {
public:
  /// Errors: `io_error`, `bad_input` and `invalid_argument` for files that are missing, cut off,
  /// open to others, of another authority, ended or not of a server; `invalid_argument` for an
  /// address that is none; `service_unavailable` when it cannot be listened on.
  [[nodiscard]] static expected<std::unique_ptr<door>> open(door_options options);

  door(const door&) = delete;
  door& operator=(const door&) = delete;
  /// Cuts all links.
  ~door();

  [[nodiscard]] std::uint16_t port() const;
  /// Who is linked, in the order in which they came. From any thread.
  [[nodiscard]] std::vector<link_peer> peers() const;
  /// How many were turned away. From any thread.
  [[nodiscard]] refusal_counts refusals() const;

private:
  struct impl;
  explicit door(std::unique_ptr<impl> state);
  std::unique_ptr<impl> impl_;
};

}  // namespace tedit::actors
