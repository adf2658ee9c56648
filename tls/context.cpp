// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tls/context.hpp"

#include <arpa/inet.h>

#include <utility>  // Boost.Asio 1.74 uses it without including it.

#include <array>
#include <cctype>

#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <boost/asio/ssl/context.hpp>

#include "certs/pem.hpp"

namespace tedit::tls {

namespace {

/// What a server shows a client may be as long; a public authority's chain has 6 KB.
constexpr long most_certificate_bytes = 65536;

std::string name_text(X509_NAME* name) {
  std::array<char, 256> text{};
  X509_NAME_oneline(name, text.data(), static_cast<int>(text.size()));
  return text.data();
}

error cannot_set_up() {
  return {ec::internal,
          "TLS cannot be set up: " + certs::openssl_complaint(),
          "This is a defect of TEdit or of its OpenSSL: please report it",
          {}};
}

}  // namespace

// -- context -------------------------------------------------------------------------------------

context::~context() {
  SSL_CTX_free(native_);
}

boost::asio::ssl::context context::for_asio() const {
  SSL_CTX_up_ref(native_);
  return boost::asio::ssl::context(native_);
}

/// No session is resumed: one would outlive a certificate that was exchanged.
expected<std::shared_ptr<context>> context::make() {
  ERR_clear_error();
  auto made = std::make_shared<context>();
  made->native_ = SSL_CTX_new(TLS_method());
  if (made->native_ == nullptr ||
      SSL_CTX_set_min_proto_version(made->native_, TLS1_3_VERSION) != 1 ||
      SSL_CTX_set_max_proto_version(made->native_, TLS1_3_VERSION) != 1 ||
      SSL_CTX_set_num_tickets(made->native_, 0) != 1)
    return fail(cannot_set_up());
  SSL_CTX_set_options(made->native_, SSL_OP_NO_TICKET);
  SSL_CTX_set_session_cache_mode(made->native_, SSL_SESS_CACHE_OFF);
  SSL_CTX_set_max_cert_list(made->native_, most_certificate_bytes);
  SSL_CTX_set_mode(made->native_, SSL_MODE_RELEASE_BUFFERS);  // Who idles costs no 34 KB.
  return made;
}

expected<std::shared_ptr<const context>> context::of_server(const std::vector<x509_st*>& chain,
                                                            evp_pkey_st& key) {
  auto made = make();
  if (!made)
    return fail(made.error());
  auto* native = (*made)->native_;
  if (chain.empty() || SSL_CTX_use_certificate(native, chain.front()) != 1 ||
      SSL_CTX_use_PrivateKey(native, &key) != 1)
    return fail(ec::invalid_argument,
                "the key and the certificate do not belong together: " + certs::openssl_complaint(),
                "Take both from one place");
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (SSL_CTX_add1_chain_cert(native, chain[i]) != 1)
      return fail(cannot_set_up());
  return *std::move(made);
}

expected<std::shared_ptr<const context>> context::of_client(
  const std::filesystem::path& authority) {
  auto made = make();
  if (!made)
    return fail(made.error());
  auto* native = (*made)->native_;
  // Looked at by `certificate_of`, so that a certificate that is not trusted can be told.
  SSL_CTX_set_verify(native, SSL_VERIFY_NONE, nullptr);
  if (authority.empty()) {
    SSL_CTX_set_default_verify_paths(native);
  } else if (SSL_CTX_load_verify_file(native, authority.c_str()) != 1) {
    return fail(ec::io_error,
                "cannot read the certificate of an authority from " + authority.string() + ": " +
                  certs::openssl_complaint(),
                "Give a PEM file, as ca.crt in a folder of \"tedit certs\"");
  }
  ERR_clear_error();
  return *std::move(made);
}

// -- what a server showed ------------------------------------------------------------------------

std::string fingerprint_of(const x509_st& one) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned size = 0;
  if (X509_digest(&one, EVP_sha256(), bytes.data(), &size) != 1)
    return {};
  constexpr auto digits = "0123456789ABCDEF";
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    text += i == 0 ? "" : ":";
    text += digits[bytes[i] >> 4];
    text += digits[bytes[i] & 15];
  }
  return text;
}

std::string read_fingerprint(std::string_view text) {
  constexpr std::size_t digits = 64;
  constexpr std::string_view before = "SHA256:";
  if (text.starts_with(before))
    text.remove_prefix(before.size());
  std::string plain;
  for (const char c : text)
    if (std::isxdigit(static_cast<unsigned char>(c)) != 0)
      plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    else if (c != ':')
      return {};
  if (plain.size() != digits)
    return {};
  std::string result;
  for (std::size_t i = 0; i < digits; i += 2)
    result += (i == 0 ? "" : ":") + plain.substr(i, 2);
  return result;
}

bool expect_host(ssl_st* connection, const std::string& host) {
  in6_addr bytes{};
  if (inet_pton(AF_INET, host.c_str(), &bytes) == 1 ||
      inet_pton(AF_INET6, host.c_str(), &bytes) == 1)
    return X509_VERIFY_PARAM_set1_ip_asc(SSL_get0_param(connection), host.c_str()) == 1;
  SSL_set_hostflags(connection,
                    X509_CHECK_FLAG_NO_PARTIAL_WILDCARDS | X509_CHECK_FLAG_NEVER_CHECK_SUBJECT);
  return SSL_set1_host(connection, host.c_str()) == 1 &&
         SSL_set_tlsext_host_name(connection, host.c_str()) == 1;
}

shown_certificate certificate_of(const ssl_st* connection) {
  shown_certificate shown;
  auto* one = SSL_get0_peer_certificate(connection);
  if (one == nullptr) {
    shown.fault = "it showed none";
    return shown;
  }
  shown.fingerprint = fingerprint_of(*one);
  shown.name = name_text(X509_get_subject_name(one));
  shown.issuer = name_text(X509_get_issuer_name(one));
  shown.hosts = certs::hosts_of(*one);
  shown.until = certs::time_of(X509_get0_notAfter(one));
  if (const auto result = SSL_get_verify_result(connection); result != X509_V_OK)
    shown.fault = X509_verify_cert_error_string(result);
  return shown;
}

std::string why_refused(unsigned long reason) {
  switch (ERR_GET_REASON(reason)) {
    case SSL_R_UNSUPPORTED_PROTOCOL:
    case SSL_R_VERSION_TOO_LOW:
    case SSL_R_TLSV1_ALERT_PROTOCOL_VERSION:
      return "it does not speak TLS 1.3";
    case SSL_R_WRONG_VERSION_NUMBER:
    case SSL_R_HTTP_REQUEST:
    case SSL_R_BAD_RECORD_TYPE:
    case SSL_R_PACKET_LENGTH_TOO_LONG:
      return "it does not speak TLS";
    default: {
      const char* text = ERR_reason_error_string(reason);
      return text != nullptr ? std::string("the TLS handshake failed: ") + text
                             : "the TLS handshake failed";
    }
  }
}

}  // namespace tedit::tls
