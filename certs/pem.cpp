// SPDX-License-Identifier: AGPL-3.0-or-later
#include "certs/pem.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <cctype>
#include <cerrno>
#include <ctime>

#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::certs {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t{1} << 20;

/// Without it OpenSSL asks the terminal, for good in a server.
int no_passphrase(char*, int, int, void*) {
  return -1;
}

bio_ptr bio_of(const std::string& text) {
  return bio_ptr(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

/// Only space may follow: a second certificate or half of one is no accident that goes unsaid.
bool is_all_read(BIO& bio) {
  char c = 0;
  while (BIO_read(&bio, &c, 1) == 1)
    if (std::isspace(static_cast<unsigned char>(c)) == 0)
      return false;
  return true;
}

template <class Pointer, class Read>
expected<Pointer> parse(const fs::path& file, const std::string& text, const char* what,
                        Read read) {
  ERR_clear_error();
  const auto bio = bio_of(text);
  Pointer one(bio ? read(bio.get()) : nullptr);
  if (!one)
    return fail(ec::bad_input, file.string() + " holds no " + what + ": " + openssl_complaint(),
                "Copy the file again from where \"tedit certs\" wrote it");
  if (!is_all_read(*bio))
    return fail(ec::bad_input, file.string() + " holds more than one " + what,
                "Copy the file again from where \"tedit certs\" wrote it");
  return one;
}

std::string written(const bio_ptr& bio) {
  char* data = nullptr;
  const auto size = BIO_get_mem_data(bio.get(), &data);
  return {data, static_cast<std::size_t>(size)};
}

/// The text of the only entry of this kind; empty when there is none, more than one, or a zero in
/// it, behind which something else could hide.
std::string only_entry(X509& one, int nid) {
  const auto* subject = X509_get_subject_name(&one);
  const int at = X509_NAME_get_index_by_NID(subject, nid, -1);
  if (at < 0 || X509_NAME_get_index_by_NID(subject, nid, at) >= 0)
    return {};
  unsigned char* text = nullptr;
  const int size =
    ASN1_STRING_to_UTF8(&text, X509_NAME_ENTRY_get_data(X509_NAME_get_entry(subject, at)));
  if (size < 0)
    return {};
  std::string result(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size));
  OPENSSL_free(text);
  return result.find('\0') == std::string::npos ? result : std::string{};
}

std::string address_text(const ASN1_OCTET_STRING& bytes) {
  char text[INET6_ADDRSTRLEN] = "";
  const int family = ASN1_STRING_length(&bytes) == 4 ? AF_INET : AF_INET6;
  if (family == AF_INET || ASN1_STRING_length(&bytes) == 16)
    inet_ntop(family, ASN1_STRING_get0_data(&bytes), text, sizeof(text));
  return text;
}

}  // namespace

std::string openssl_complaint() {
  const auto code = ERR_peek_last_error();
  ERR_clear_error();
  const char* reason = ERR_reason_error_string(code);
  return reason != nullptr ? reason : "OpenSSL gives no reason";
}

expected<std::string> read_small_file(const fs::path& file) {
  const unique_fd in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat about {};
  if (!in || ::fstat(in.get(), &about) != 0)
    return system_failure("cannot read " + file.string(), errno);
  if (!S_ISREG(about.st_mode) || about.st_size > static_cast<off_t>(most_bytes))
    return fail(ec::bad_input, file.string() + " is no file of \"tedit certs\"",
                "Name the folder that \"tedit certs\" wrote");
  std::string text(static_cast<std::size_t>(about.st_size), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const auto got = ::read(in.get(), text.data() + done, text.size() - done);
    if (got < 0 && errno != EINTR)
      return system_failure("cannot read " + file.string(), errno);
    if (got == 0)
      break;
    done += got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  text.resize(done);
  return text;
}

expected<x509_ptr> read_certificate(const fs::path& file) {
  return read_small_file(file).and_then([&](const std::string& text) {
    return parse<x509_ptr>(file, text, "certificate", [](BIO* bio) {
      return PEM_read_bio_X509(bio, nullptr, no_passphrase, nullptr);
    });
  });
}

expected<std::vector<x509_ptr>> read_chain(const fs::path& file) {
  return read_small_file(file).and_then(
    [&](const std::string& text) -> expected<std::vector<x509_ptr>> {
      std::vector<x509_ptr> chain;
      const bio_ptr bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
      while (x509_ptr one{PEM_read_bio_X509(bio.get(), nullptr, no_passphrase, nullptr)})
        chain.push_back(std::move(one));
      const bool at_end = ERR_GET_REASON(ERR_peek_last_error()) == PEM_R_NO_START_LINE;
      ERR_clear_error();
      if (chain.empty() || !at_end)
        return fail(
          ec::bad_input, file.string() + " is no list of certificates, or has something else in it",
          "Give the certificate and those of its authorities in PEM, one after the other");
      return chain;
    });
}

expected<crl_ptr> read_revoked(const fs::path& file) {
  return read_small_file(file).and_then([&](const std::string& text) {
    return parse<crl_ptr>(file, text, "list of revoked certificates", [](BIO* bio) {
      return PEM_read_bio_X509_CRL(bio, nullptr, no_passphrase, nullptr);
    });
  });
}

expected<key_ptr> read_key(const fs::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) == 0 && (about.st_mode & 077) != 0)
    return fail(ec::invalid_argument, "others may read the key in " + file.string(),
                "chmod 600 " + file.string() +
                  "; if somebody could have read it, revoke its certificate and issue another");
  return read_small_file(file).and_then([&](const std::string& text) -> expected<key_ptr> {
    if (text.find("ENCRYPTED") != std::string::npos)
      return fail(ec::invalid_argument, "a passphrase guards the key in " + file.string(),
                  "Nobody is there to type it: take the passphrase off (openssl pkey)");
    return parse<key_ptr>(file, text, "private key", [](BIO* bio) {
      return PEM_read_bio_PrivateKey(bio, nullptr, no_passphrase, nullptr);
    });
  });
}

std::string to_pem(X509& one) {
  const bio_ptr bio(BIO_new(BIO_s_mem()));
  PEM_write_bio_X509(bio.get(), &one);
  return written(bio);
}

std::string to_pem(X509_CRL& one) {
  const bio_ptr bio(BIO_new(BIO_s_mem()));
  PEM_write_bio_X509_CRL(bio.get(), &one);
  return written(bio);
}

std::string to_pem(EVP_PKEY& one) {
  const bio_ptr bio(BIO_new(BIO_s_mem()));
  PEM_write_bio_PrivateKey(bio.get(), &one, nullptr, nullptr, 0, nullptr, nullptr);
  return written(bio);
}

std::string common_name(X509& one) {
  return only_entry(one, NID_commonName);
}

std::vector<std::string> hosts_of(X509& one) {
  using names_ptr = std::unique_ptr<GENERAL_NAMES, openssl_end<GENERAL_NAMES_free>>;
  std::vector<std::string> hosts;
  const names_ptr names(
    static_cast<GENERAL_NAMES*>(X509_get_ext_d2i(&one, NID_subject_alt_name, nullptr, nullptr)));
  for (int i = 0; names && i < sk_GENERAL_NAME_num(names.get()); ++i) {
    const auto* name = sk_GENERAL_NAME_value(names.get(), i);
    if (name->type == GEN_DNS)
      hosts.emplace_back(reinterpret_cast<const char*>(ASN1_STRING_get0_data(name->d.dNSName)),
                         static_cast<std::size_t>(ASN1_STRING_length(name->d.dNSName)));
    else if (name->type == GEN_IPADD)
      hosts.push_back(address_text(*name->d.iPAddress));
  }
  return hosts;
}

std::int64_t time_of(const ASN1_TIME* when) {
  std::tm parts{};
  return ASN1_TIME_to_tm(when, &parts) == 1 ? static_cast<std::int64_t>(timegm(&parts)) : 0;
}

std::string serial_text(const ASN1_INTEGER* number) {
  using number_ptr = std::unique_ptr<BIGNUM, openssl_end<BN_free>>;
  const number_ptr value(ASN1_INTEGER_to_BN(number, nullptr));
  char* text = value ? BN_bn2hex(value.get()) : nullptr;
  std::string digits = text != nullptr ? text : "";
  OPENSSL_free(text);
  for (auto& c : digits)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::string(digits.size() < 16 ? 16 - digits.size() : 0, '0') + digits;
}

list_facts facts_of(X509_CRL& list) {
  using integer_ptr = std::unique_ptr<ASN1_INTEGER, openssl_end<ASN1_INTEGER_free>>;
  const integer_ptr number(
    static_cast<ASN1_INTEGER*>(X509_CRL_get_ext_d2i(&list, NID_crl_number, nullptr, nullptr)));
  list_facts facts;
  // One that needs more than 63 bits is no number of ours, and tells no order.
  std::int64_t value = 0;
  if (number && ASN1_INTEGER_get_int64(&value, number.get()) == 1 && value > 0)
    facts.number = value;
  facts.from = time_of(X509_CRL_get0_lastUpdate(&list));
  if (const auto* until = X509_CRL_get0_nextUpdate(&list))
    facts.until = time_of(until);
  ERR_clear_error();
  return facts;
}

std::set<std::string> serials_of(X509_CRL& list) {
  std::set<std::string> serials;
  auto* rows = X509_CRL_get_REVOKED(&list);
  for (int i = 0; i < sk_X509_REVOKED_num(rows); ++i)
    serials.insert(serial_text(X509_REVOKED_get0_serialNumber(sk_X509_REVOKED_value(rows, i))));
  return serials;
}

expected<certificate> read_facts(X509& one) {
  certificate facts;
  facts.name = common_name(one);
  const auto what = role_named(only_entry(one, NID_organizationalUnitName));
  if (facts.name.empty() || !what)
    return fail(ec::bad_input, "the certificate names no node and role of TEdit",
                "Issue one with \"tedit certs issue\"");
  facts.what = *what;
  facts.serial = serial_text(X509_get0_serialNumber(&one));
  facts.hosts = hosts_of(one);
  facts.from = time_of(X509_get0_notBefore(&one));
  facts.until = time_of(X509_get0_notAfter(&one));
  return facts;
}

}  // namespace tedit::certs
