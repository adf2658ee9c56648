// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "tls/shown_certificate.hpp"

struct ssl_ctx_st;
struct ssl_st;
struct x509_st;
struct evp_pkey_st;

namespace boost::asio::ssl {
class context;
}

/// TLS between a server and those who use it: 1.3 alone, the server with a certificate, who uses it
/// with none. Between nodes it is another matter (actors/links).
namespace tedit::tls {

/// Settings of OpenSSL. They never change; connections share them.
class context {
public:
  context() = default;
  context(const context&) = delete;
  context& operator=(const context&) = delete;
  ~context();

  /// A server's: its certificate, those that lead from it to an authority, its key.
  /// Errors: `invalid_argument` when key and certificate do not belong together.
  [[nodiscard]] static expected<std::shared_ptr<const context>> of_server(
    const std::vector<x509_st*>& chain, evp_pkey_st& key);

  /// A client's. `authority`: PEM file of those that are trusted; empty: the system's.
  /// Errors: `io_error` for a file that cannot be read or has no certificate.
  [[nodiscard]] static expected<std::shared_ptr<const context>> of_client(
    const std::filesystem::path& authority);

  /// An owner as Boost.Asio wants it.
  [[nodiscard]] boost::asio::ssl::context for_asio() const;

private:
  [[nodiscard]] static expected<std::shared_ptr<context>> make();

  ssl_ctx_st* native_ = nullptr;
};

/// SHA-256 of a certificate, as "AB:CD:...".
[[nodiscard]] std::string fingerprint_of(const x509_st& one);

/// A fingerprint that a person wrote, in that form; empty when it is none. Colons, case and
/// "SHA256:" before it do not matter.
[[nodiscard]] std::string read_fingerprint(std::string_view text);

/// Before the handshake of a client: which host is meant. False when it cannot be one.
[[nodiscard]] bool expect_host(ssl_st* connection, const std::string& host);

/// After the handshake of a client, which succeeds whatever is shown: nothing may be said before
/// this was looked at.
[[nodiscard]] shown_certificate certificate_of(const ssl_st* connection);

/// Why a handshake failed, as the end of a sentence ("it does not speak TLS").
/// @param reason OpenSSL's number.
[[nodiscard]] std::string why_refused(unsigned long reason);

}  // namespace tedit::tls
