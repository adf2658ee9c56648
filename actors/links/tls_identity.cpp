// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/tls_identity.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <utility>

#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include "base/utc.hpp"
#include "certs/make.hpp"
#include "certs/pem.hpp"

namespace tedit::actors {

namespace {

namespace fs = std::filesystem;

/// A certificate of ours has 700 bytes.
constexpr long most_certificate_bytes = 16384;

/// Where a context of OpenSSL keeps ours. Asio has the place that "app data" means.
int context_place() {
  static const int place = SSL_CTX_get_ex_new_index(0, nullptr, nullptr, nullptr, nullptr);
  return place;
}

/// After OpenSSL's own checks: role and revocation of the peer.
int check_peer(int good, X509_STORE_CTX* store) {
  if (good != 1 || X509_STORE_CTX_get_error_depth(store) != 0)
    return good;
  const auto* tls = static_cast<const SSL*>(
    X509_STORE_CTX_get_ex_data(store, SSL_get_ex_data_X509_STORE_CTX_idx()));
  const auto* ours =
    static_cast<const tls_context*>(SSL_CTX_get_ex_data(SSL_get_SSL_CTX(tls), context_place()));
  const auto facts = certs::read_facts(*X509_STORE_CTX_get_current_cert(store));
  if (!facts || !ours->admits(facts->what)) {
    X509_STORE_CTX_set_error(store, X509_V_ERR_INVALID_PURPOSE);
    return 0;
  }
  if (ours->has_revoked(facts->serial)) {
    X509_STORE_CTX_set_error(store, X509_V_ERR_CERT_REVOKED);
    return 0;
  }
  return 1;
}

/// The protocol's name with its length before it, as ALPN has it.
std::string wire_protocol() {
  return static_cast<char>(tls_protocol.size()) + std::string(tls_protocol);
}

int choose_protocol(SSL*, const unsigned char** chosen, unsigned char* size,
                    const unsigned char* offered, unsigned offered_size, void*) {
  static const std::string ours = wire_protocol();
  unsigned char* found = nullptr;
  const bool known =
    SSL_select_next_proto(&found, size, reinterpret_cast<const unsigned char*>(ours.data()),
                          static_cast<unsigned>(ours.size()), offered,
                          offered_size) == OPENSSL_NPN_NEGOTIATED;
  *chosen = found;
  return known ? SSL_TLSEXT_ERR_OK : SSL_TLSEXT_ERR_ALERT_FATAL;
}

bool configure(SSL_CTX& to, tls_side side, X509& own, EVP_PKEY& key, X509& authority) {
  const auto ours = wire_protocol();
  SSL_CTX_set_options(&to, SSL_OP_NO_TICKET);
  SSL_CTX_set_session_cache_mode(&to, SSL_SESS_CACHE_OFF);
  SSL_CTX_set_max_cert_list(&to, most_certificate_bytes);
  SSL_CTX_set_verify(&to, SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, check_peer);
  SSL_CTX_set_verify_depth(&to, 0);  // Between a node and its authority there is nobody.
  if (side == tls_side::door)
    SSL_CTX_set_alpn_select_cb(&to, choose_protocol, nullptr);
  else if (SSL_CTX_set_alpn_protos(&to, reinterpret_cast<const unsigned char*>(ours.data()),
                                   static_cast<unsigned>(ours.size())) != 0)
    return false;
  return SSL_CTX_set_min_proto_version(&to, TLS1_3_VERSION) == 1 &&
         SSL_CTX_set_max_proto_version(&to, TLS1_3_VERSION) == 1 &&
         SSL_CTX_set_num_tickets(&to, 0) == 1 && SSL_CTX_use_certificate(&to, &own) == 1 &&
         SSL_CTX_use_PrivateKey(&to, &key) == 1 &&
         X509_STORE_add_cert(SSL_CTX_get_cert_store(&to), &authority) == 1;
}

/// Of certificates that were made for each other, whether this one may be used now.
expected<void> check_own(tls_side side, const certs::certificate& own, const fs::path& folder) {
  if (side == tls_side::door && own.what != certs::role::server)
    return fail(ec::invalid_argument,
                "the certificate in " + folder.string() + " is of role " +
                  std::string(certs::role_name(own.what)) + ", and only a server opens a door",
                "Issue one with --role server");
  if (own.until <= certs::now_s())
    return fail(ec::invalid_argument,
                "the certificate in " + folder.string() + " ended at " + utc_text(own.until),
                "Renew it: tedit certs renew");
  return {};
}

struct node_files {
  certs::x509_ptr own;
  certs::key_ptr key;
  certs::x509_ptr authority;
};

expected<node_files> read_node(const fs::path& folder) {
  auto own = certs::read_certificate(folder / certs::node_certificate_file);
  if (!own)
    return fail(own.error());
  auto key = certs::read_key(folder / certs::node_key_file);
  if (!key)
    return fail(key.error());
  auto authority = certs::read_certificate(folder / certs::authority_certificate_file);
  if (!authority)
    return fail(authority.error());
  const bool match = X509_check_private_key(own->get(), key->get()) == 1 &&
                     X509_verify(own->get(), X509_get0_pubkey(authority->get())) == 1;
  ERR_clear_error();
  if (!match)
    return fail(ec::invalid_argument,
                "the key, the certificate and the authority's certificate in " + folder.string() +
                  " do not belong together",
                "Take all of them from one folder that \"tedit certs\" wrote");
  return node_files{std::move(*own), std::move(*key), std::move(*authority)};
}

expected<certs::crl_ptr> read_list(const fs::path& file, X509& authority) {
  auto list = certs::read_revoked(file);
  if (!list)
    return list;
  const bool ours = X509_CRL_verify(list->get(), X509_get0_pubkey(&authority)) == 1;
  ERR_clear_error();
  if (!ours)
    return fail(ec::invalid_argument, file.string() + " is the list of another authority",
                "Take the one in the folder of the authority that issued this node's certificate");
  return list;
}

}  // namespace

std::string_view refusal_text(refusal why) {
  switch (why) {
    case refusal::silent:
      return "it did not say who it is in time";
    case refusal::crowded:
      return "too many connections did not say who they are";
    case refusal::full:
      return "there are as many links as may be";
    case refusal::gone:
      return "it left before it had said who it is";
    case refusal::not_tls:
      return "it does not speak TLS";
    case refusal::old_tls:
      return "it does not speak TLS 1.3";
    case refusal::not_a_node:
      return "it is no node of TEdit";
    case refusal::no_certificate:
      return "it has no certificate";
    case refusal::other_authority:
      return "its certificate is not of this authority";
    case refusal::ended:
      return "its certificate has ended or not begun";
    case refusal::revoked:
      return "its certificate was revoked";
    case refusal::wrong_role:
      return "its role is not admitted";
    case refusal::wrong_host:
      return "its certificate does not hold for the host that was dialled";
    case refusal::refused_us:
      return "it did not want this node";
    case refusal::too_often:
      return "too many tries before it had failed";
  }
  return "";
}

// -- tls_context ---------------------------------------------------------------------------------

tls_context::~tls_context() {
  SSL_CTX_free(native_);
}

expected<std::shared_ptr<const tls_context>> tls_context::make(
  tls_side side, const std::set<certs::role>& admitted, const fs::path& folder,
  const fs::path& revoked) {
  const auto files = read_node(folder);
  if (!files)
    return fail(files.error());
  auto facts = certs::read_facts(*files->own);
  if (!facts)
    return fail(facts.error());
  if (auto ok = check_own(side, *facts, folder); !ok)
    return fail(ok.error());
  auto made = std::make_shared<tls_context>();
  if (!revoked.empty()) {
    const auto list = read_list(revoked, *files->authority);
    if (!list)
      return fail(list.error());
    made->revoked_ = certs::serials_of(**list);
    made->list_ = certs::facts_of(**list);
  }
  made->side_ = side;
  made->own_ = std::move(*facts);
  made->authority_ = certs::common_name(*files->authority);
  made->authority_pem_ = certs::to_pem(*files->authority);
  made->admitted_ = admitted;
  ERR_clear_error();
  made->native_ = SSL_CTX_new(TLS_method());
  if (made->native_ == nullptr ||
      !configure(*made->native_, side, *files->own, *files->key, *files->authority) ||
      SSL_CTX_set_ex_data(made->native_, context_place(), made.get()) != 1)
    return fail(ec::internal, "TLS cannot be set up: " + certs::openssl_complaint(),
                "This is a defect of TEdit or of its OpenSSL: please report it");
  return made;
}

// -- tls_identity --------------------------------------------------------------------------------

expected<tls_identity> tls_identity::load(tls_side side, std::set<certs::role> admitted,
                                          fs::path folder, fs::path revoked) {
  tls_identity made;
  made.side_ = side;
  made.admitted_ = std::move(admitted);
  made.folder_ = std::move(folder);
  made.revoked_ = std::move(revoked);
  std::error_code code;
  if (const auto file = made.folder_ / certs::revoked_file;
      made.revoked_.empty() && (side == tls_side::door || fs::exists(file, code)))
    made.revoked_ = file;
  if (auto ok = made.look(); !ok)
    return fail(ok.error());
  return made;
}

tls_identity::stamps tls_identity::look_at_files() const {
  const std::array files{folder_ / certs::node_certificate_file, folder_ / certs::node_key_file,
                         folder_ / certs::authority_certificate_file, revoked_};
  stamps found{};
  std::ranges::transform(files, found.begin(), stamp_of);
  return found;
}

expected<void> tls_identity::check_order(const std::shared_ptr<const tls_context>& next) const {
  if (!context_ || !context_->list() || !next->list() ||
      context_->authority_pem() != next->authority_pem())
    return {};
  const auto before = context_->list()->number;
  const auto now = next->list()->number;
  if (now >= before)
    return {};
  return fail(ec::conflict,
              revoked_.string() + " is older than the list that was read before it: number " +
                std::to_string(now) + " after " + std::to_string(before) +
                "; who was revoked since would be let in again",
              "Copy the newest crl.pem of the authority's folder there; after it was made anew, "
              "restart");
}

expected<void> tls_identity::look() {
  const auto now = look_at_files();
  if (context_ && now == seen_)
    return {};
  seen_ = now;
  auto made = tls_context::make(side_, admitted_, folder_, revoked_);
  if (!made)
    return fail(made.error());
  if (auto ok = check_order(*made); !ok)
    return ok;
  context_ = std::move(*made);
  return {};
}

// -- what a handshake found ----------------------------------------------------------------------

namespace {

refusal of_verification(long result) {
  switch (result) {
    case X509_V_ERR_CERT_HAS_EXPIRED:
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return refusal::ended;
    case X509_V_ERR_CERT_REVOKED:
      return refusal::revoked;
    case X509_V_ERR_INVALID_PURPOSE:
      return refusal::wrong_role;
    case X509_V_ERR_HOSTNAME_MISMATCH:
    case X509_V_ERR_IP_ADDRESS_MISMATCH:
      return refusal::wrong_host;
    default:
      return refusal::other_authority;
  }
}

}  // namespace

tls_failure explain_failure(const ssl_st* tls, unsigned long reason) {
  if (const auto result = SSL_get_verify_result(tls); result != X509_V_OK)
    return {of_verification(result)};
  if (reason == 0)
    return {refusal::gone};
  switch (ERR_GET_REASON(reason)) {
    case SSL_R_PEER_DID_NOT_RETURN_A_CERTIFICATE:
      return {refusal::no_certificate};
    case SSL_R_UNSUPPORTED_PROTOCOL:
    case SSL_R_VERSION_TOO_LOW:
    case SSL_R_TLSV1_ALERT_PROTOCOL_VERSION:
      return {refusal::old_tls};
    case SSL_R_NO_APPLICATION_PROTOCOL:
    case SSL_R_TLSV1_ALERT_NO_APPLICATION_PROTOCOL:
      return {refusal::not_a_node};
    // What follows a peer says of this side's certificate.
    case SSL_R_SSLV3_ALERT_CERTIFICATE_REVOKED:
      return {refusal::revoked, true};
    case SSL_R_SSLV3_ALERT_CERTIFICATE_EXPIRED:
      return {refusal::ended, true};
    case SSL_R_SSLV3_ALERT_UNSUPPORTED_CERTIFICATE:
      return {refusal::wrong_role, true};
    case SSL_R_TLSV1_ALERT_UNKNOWN_CA:
    case SSL_R_SSLV3_ALERT_BAD_CERTIFICATE:
    case SSL_R_TLSV1_ALERT_DECRYPT_ERROR:
      return {refusal::other_authority, true};
    case SSL_R_SSLV3_ALERT_HANDSHAKE_FAILURE:
    case SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN:
    case SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED:
    case SSL_R_TLSV1_ALERT_INTERNAL_ERROR:
      return {refusal::refused_us, true};
    default:
      return {refusal::not_tls};
  }
}

tl::expected<link_peer, refusal> peer_of(const ssl_st* tls) {
  const unsigned char* chosen = nullptr;
  unsigned size = 0;
  SSL_get0_alpn_selected(tls, &chosen, &size);
  if (std::string_view(reinterpret_cast<const char*>(chosen), size) != tls_protocol)
    return tl::unexpected(refusal::not_a_node);
  auto* shown = SSL_get0_peer_certificate(tls);
  if (shown == nullptr || SSL_get_verify_result(tls) != X509_V_OK)
    return tl::unexpected(refusal::no_certificate);
  const auto facts = certs::read_facts(*shown);
  if (!facts)
    return tl::unexpected(refusal::wrong_role);
  return link_peer{facts->name, facts->what, facts->serial, {}, facts->until};
}

bool expect_host(ssl_st* tls, const std::string& host) {
  in6_addr bytes{};
  if (inet_pton(AF_INET, host.c_str(), &bytes) == 1 ||
      inet_pton(AF_INET6, host.c_str(), &bytes) == 1)
    return X509_VERIFY_PARAM_set1_ip_asc(SSL_get0_param(tls), host.c_str()) == 1;
  SSL_set_hostflags(tls, X509_CHECK_FLAG_NO_WILDCARDS | X509_CHECK_FLAG_NEVER_CHECK_SUBJECT);
  return SSL_set1_host(tls, host.c_str()) == 1 && SSL_set_tlsext_host_name(tls, host.c_str()) == 1;
}

}  // namespace tedit::actors
