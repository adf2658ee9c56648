// SPDX-License-Identifier: AGPL-3.0-or-later
#include "certs/make.hpp"

#include <ctime>

#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include "certs/pem.hpp"

namespace tedit::certs {

namespace {

constexpr long version_3 = 2;
constexpr long list_version_2 = 1;

tl::unexpected<error> openssl_failure(const std::string& what) {
  return fail(ec::internal, "cannot make " + what + ": " + openssl_complaint(),
              "This is a defect of TEdit or of its OpenSSL: please report it");
}

/// Of 63 bits: a serial must be positive, and by chance no two of one authority are alike.
bool set_serial(X509& one) {
  std::uint64_t number = 0;
  if (RAND_bytes(reinterpret_cast<unsigned char*>(&number), sizeof(number)) != 1)
    return false;
  return ASN1_INTEGER_set_uint64(X509_get_serialNumber(&one), (number >> 1) | 1) == 1;
}

bool set_times(X509& one, std::int64_t from, std::int64_t until) {
  return ASN1_TIME_set(X509_getm_notBefore(&one), from) != nullptr &&
         ASN1_TIME_set(X509_getm_notAfter(&one), until) != nullptr;
}

bool add_entry(X509_NAME& name, int nid, std::string_view text) {
  return X509_NAME_add_entry_by_NID(&name, nid, MBSTRING_UTF8,
                                    reinterpret_cast<const unsigned char*>(text.data()),
                                    static_cast<int>(text.size()), -1, 0) == 1;
}

bool add_extension(X509& one, X509& issuer, int nid, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx(&context, &issuer, &one, nullptr, nullptr, 0);
  using extension_ptr = std::unique_ptr<X509_EXTENSION, openssl_end<X509_EXTENSION_free>>;
  const extension_ptr made(X509V3_EXT_conf_nid(nullptr, &context, nid, value.c_str()));
  return made && X509_add_ext(&one, made.get(), -1) == 1;
}

expected<identity> begin(std::int64_t from, std::int64_t until) {
  ERR_clear_error();
  identity made{x509_ptr(X509_new()), key_ptr(EVP_EC_gen("P-256"))};
  if (!made.key)
    return openssl_failure("a key");
  if (!made.certificate || X509_set_version(made.certificate.get(), version_3) != 1 ||
      !set_serial(*made.certificate) || !set_times(*made.certificate, from, until) ||
      X509_set_pubkey(made.certificate.get(), made.key.get()) != 1)
    return openssl_failure("a certificate");
  return made;
}

/// "DNS:hall,IP:10.0.0.7": the hosts were checked to have no comma.
std::string alternatives(const order& what) {
  std::string text = "DNS:" + what.name;
  for (const auto& host : what.hosts) {
    using octets_ptr = std::unique_ptr<ASN1_OCTET_STRING, openssl_end<ASN1_OCTET_STRING_free>>;
    const octets_ptr address(a2i_IPADDRESS(host.c_str()));
    if (host != what.name)
      text += (address ? ",IP:" : ",DNS:") + host;
  }
  return text;
}

bool describe_node(X509& one, X509& issuer, const order& what) {
  auto& subject = *X509_get_subject_name(&one);
  const std::string use = what.what == role::server ? "serverAuth" : "clientAuth";
  return add_entry(subject, NID_organizationName, "TEdit") &&
         add_entry(subject, NID_organizationalUnitName, role_name(what.what)) &&
         add_entry(subject, NID_commonName, what.name) &&
         X509_set_issuer_name(&one, X509_get_subject_name(&issuer)) == 1 &&
         add_extension(one, issuer, NID_basic_constraints, "critical,CA:FALSE") &&
         add_extension(one, issuer, NID_key_usage, "critical,digitalSignature") &&
         add_extension(one, issuer, NID_ext_key_usage, use) &&
         add_extension(one, issuer, NID_subject_alt_name, alternatives(what)) &&
         add_extension(one, issuer, NID_subject_key_identifier, "hash") &&
         add_extension(one, issuer, NID_authority_key_identifier, "keyid:always");
}

bool describe_authority(X509& one, const std::string& name) {
  auto& subject = *X509_get_subject_name(&one);
  return add_entry(subject, NID_organizationName, "TEdit") &&
         add_entry(subject, NID_commonName, name) && X509_set_issuer_name(&one, &subject) == 1 &&
         add_extension(one, one, NID_basic_constraints, "critical,CA:TRUE,pathlen:0") &&
         add_extension(one, one, NID_key_usage, "critical,keyCertSign,cRLSign") &&
         add_extension(one, one, NID_subject_key_identifier, "hash");
}

bool add_revoked(X509_CRL& list, const std::string& serial, const ASN1_TIME& when) {
  using row_ptr = std::unique_ptr<X509_REVOKED, openssl_end<X509_REVOKED_free>>;
  row_ptr row(X509_REVOKED_new());
  BIGNUM* value = nullptr;
  if (!row || BN_hex2bn(&value, serial.c_str()) == 0)
    return false;
  const std::unique_ptr<BIGNUM, openssl_end<BN_free>> owned(value);
  using integer_ptr = std::unique_ptr<ASN1_INTEGER, openssl_end<ASN1_INTEGER_free>>;
  const integer_ptr number(BN_to_ASN1_INTEGER(value, nullptr));
  if (!number || X509_REVOKED_set_serialNumber(row.get(), number.get()) != 1 ||
      X509_REVOKED_set_revocationDate(row.get(), const_cast<ASN1_TIME*>(&when)) != 1 ||
      X509_CRL_add0_revoked(&list, row.get()) != 1)
    return false;
  static_cast<void>(row.release());  // The list owns it now.
  return true;
}

/// One above the number of `old`.
bool set_list_number(X509_CRL& list, X509_CRL* old) {
  using integer_ptr = std::unique_ptr<ASN1_INTEGER, openssl_end<ASN1_INTEGER_free>>;
  const integer_ptr before(old != nullptr ? static_cast<ASN1_INTEGER*>(X509_CRL_get_ext_d2i(
                                              old, NID_crl_number, nullptr, nullptr))
                                          : nullptr);
  const integer_ptr number(ASN1_INTEGER_new());
  const long value = before ? ASN1_INTEGER_get(before.get()) + 1 : 1;
  return number && ASN1_INTEGER_set(number.get(), value) == 1 &&
         X509_CRL_add1_ext_i2d(&list, NID_crl_number, number.get(), 0, 0) == 1;
}

}  // namespace

std::int64_t now_s() {
  return static_cast<std::int64_t>(std::time(nullptr));
}

expected<identity> make_authority(const std::string& name, seconds valid) {
  const auto now = now_s();
  auto made = begin(now - before_now.count(), now + valid.count());
  if (made && (!describe_authority(*made->certificate, name) ||
               X509_sign(made->certificate.get(), made->key.get(), EVP_sha256()) == 0))
    return openssl_failure("the authority's certificate");
  return made;
}

expected<identity> make_node(const identity& authority, const order& what) {
  const auto now = now_s();
  const auto until = what.from.value_or(now) + what.valid.count();
  auto made = begin(what.from.value_or(now - before_now.count()), until);
  if (made && (!describe_node(*made->certificate, *authority.certificate, what) ||
               X509_sign(made->certificate.get(), authority.key.get(), EVP_sha256()) == 0))
    return openssl_failure("a certificate");
  return made;
}

expected<crl_ptr> make_revoked(const identity& authority, X509_CRL* old,
                               const std::set<std::string>& more) {
  ERR_clear_error();
  crl_ptr list(X509_CRL_new());
  using time_ptr = std::unique_ptr<ASN1_TIME, openssl_end<ASN1_TIME_free>>;
  const time_ptr now(ASN1_TIME_set(nullptr, now_s()));
  bool good =
    list && now && X509_CRL_set_version(list.get(), list_version_2) == 1 &&
    X509_CRL_set_issuer_name(list.get(), X509_get_subject_name(authority.certificate.get())) == 1 &&
    X509_CRL_set1_lastUpdate(list.get(), now.get()) == 1 &&
    X509_CRL_set1_nextUpdate(list.get(), X509_get0_notAfter(authority.certificate.get())) == 1 &&
    set_list_number(*list, old);
  auto* rows = old != nullptr ? X509_CRL_get_REVOKED(old) : nullptr;
  for (int i = 0; good && i < sk_X509_REVOKED_num(rows); ++i) {
    const auto* row = sk_X509_REVOKED_value(rows, i);
    good = add_revoked(*list, serial_text(X509_REVOKED_get0_serialNumber(row)),
                       *X509_REVOKED_get0_revocationDate(row));
  }
  for (const auto& serial : more)
    good = good && add_revoked(*list, serial, *now);
  if (!good || X509_CRL_sort(list.get()) != 1 ||
      X509_CRL_sign(list.get(), authority.key.get(), EVP_sha256()) == 0)
    return openssl_failure("the list of revoked certificates");
  return list;
}

}  // namespace tedit::certs
