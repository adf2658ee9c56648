// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "actors/links/refusal.hpp"
#include "base/error.hpp"
#include "base/file_stamp.hpp"
#include "certs/authority.hpp"

struct ssl_ctx_st;
struct ssl_st;

namespace tedit::actors {

/// What both sides say in the handshake (ALPN), so that no other service is taken for a node.
inline constexpr std::string_view tls_protocol = "tedit-node/1";

/// What the side that was dialled says first: the dialling side has ended its handshake before the
/// other has looked at its certificate, and learns by this that it is admitted.
inline constexpr std::string_view tls_welcome = "tedit-1\n";

enum class tls_side { door, dial };

/// Settings of OpenSSL for one state of a node's files: TLS 1.3, both sides with certificates of
/// the same authority, no session that could be resumed. It never changes; connections share it.
class tls_context {
public:
  /// Errors: those of `tls_identity::load`.
  [[nodiscard]] static expected<std::shared_ptr<const tls_context>> make(
    tls_side side, const std::set<certs::role>& admitted, const std::filesystem::path& folder,
    const std::filesystem::path& revoked);

  tls_context() = default;
  tls_context(const tls_context&) = delete;
  tls_context& operator=(const tls_context&) = delete;
  ~tls_context();

  [[nodiscard]] ssl_ctx_st* native() const { return native_; }
  [[nodiscard]] tls_side side() const { return side_; }
  [[nodiscard]] const certs::certificate& own() const { return own_; }
  [[nodiscard]] const std::string& authority() const { return authority_; }
  /// The authority's certificate, to tell whether it is another one.
  [[nodiscard]] const std::string& authority_pem() const { return authority_pem_; }
  [[nodiscard]] bool admits(certs::role what) const { return admitted_.contains(what); }
  [[nodiscard]] bool has_revoked(const std::string& serial) const {
    return revoked_.contains(serial);
  }
  /// Of the list of revoked certificates; none where there is no list.
  [[nodiscard]] const std::optional<certs::list_facts>& list() const { return list_; }

private:
  ssl_ctx_st* native_ = nullptr;
  tls_side side_ = tls_side::door;
  certs::certificate own_;
  std::string authority_;  ///< Its name.
  std::string authority_pem_;
  std::set<certs::role> admitted_;
  std::set<std::string> revoked_;
  std::optional<certs::list_facts> list_;
};

/// A node's key, certificate and authority, and who was revoked, from files that may change while
/// the node runs: they are loaded again when they do. One thread at a time.
class tls_identity {
public:
  /// @param folder what "tedit certs issue" made.
  /// @param revoked the list, which a door must have; empty: `crl.pem` in the folder, for a dial
  /// only if it is there.
  /// Errors: `io_error`, `bad_input`, `invalid_argument`, naming the file: missing, cut off, open
  /// to others, not belonging together, ended, a door's not of role server.
  [[nodiscard]] static expected<tls_identity> load(tls_side side, std::set<certs::role> admitted,
                                                   std::filesystem::path folder,
                                                   std::filesystem::path revoked = {});

  /// Loads again what changed since the last look; on an error the state before goes on, and the
  /// error comes once for each change. A list of revoked certificates with a lower number than the
  /// one before is such an error (`conflict`): who was revoked since would come in again. Cost:
  /// four `stat`; loading some milliseconds.
  [[nodiscard]] expected<void> look();

  [[nodiscard]] const std::shared_ptr<const tls_context>& context() const { return context_; }

private:
  using stamps = std::array<file_stamp, 4>;

  tls_identity() = default;
  [[nodiscard]] stamps look_at_files() const;
  [[nodiscard]] expected<void> check_order(const std::shared_ptr<const tls_context>& next) const;

  tls_side side_ = tls_side::door;
  std::set<certs::role> admitted_;
  std::filesystem::path folder_;
  std::filesystem::path revoked_;
  stamps seen_{};
  std::shared_ptr<const tls_context> context_;
};

/// What OpenSSL found out about the peer of a handshake that failed.
/// @param reason number of OpenSSL's error; 0: none, the connection ended.
struct tls_failure {
  refusal why = refusal::gone;
  bool by_peer = false;  ///< The other side said so, of this side.
};
[[nodiscard]] tls_failure explain_failure(const ssl_st* tls, unsigned long reason);

/// The peer of a handshake that succeeded. Errors: that it is none of ours.
[[nodiscard]] tl::expected<link_peer, refusal> peer_of(const ssl_st* tls);

/// Makes a connection check that the server's certificate holds for this host or IP address.
/// False when it cannot be one.
[[nodiscard]] bool expect_host(ssl_st* tls, const std::string& host);

}  // namespace tedit::actors
