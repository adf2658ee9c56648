// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "base/error.hpp"
#include "certs/authority.hpp"
#include "certs/openssl.hpp"

/// Keys, certificates and lists, made and signed in memory.
/// Errors of all: `internal` with what OpenSSL complains of.
namespace tedit::certs {

/// A certificate with its key.
struct identity {
  x509_ptr certificate;
  key_ptr key;
};

/// Clocks of machines differ: what is made now holds since then.
inline constexpr seconds before_now = std::chrono::hours(1);

[[nodiscard]] std::int64_t now_s();

[[nodiscard]] expected<identity> make_authority(const std::string& name, seconds valid);

/// @pre name, hosts and time of `what` were checked.
[[nodiscard]] expected<identity> make_node(const identity& authority, const order& what);

/// The list with one more serial for each of `more`; `old` null: an empty one. It is numbered one
/// higher and holds as long as the authority does: who reads it takes the newest there is, and a
/// server must not stop because nobody wrote it again.
[[nodiscard]] expected<crl_ptr> make_revoked(const identity& authority, X509_CRL* old,
                                             const std::set<std::string>& more);

}  // namespace tedit::certs
