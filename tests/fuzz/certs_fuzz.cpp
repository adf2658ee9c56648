// SPDX-License-Identifier: AGPL-3.0-or-later
#include <openssl/err.h>

#include "certs/pem.hpp"
#include "tests/fuzz/promise.hpp"

namespace {

using namespace tedit;

void look_at(X509& one) {
  if (const auto facts = certs::read_facts(one)) {
    fuzz::require(!facts->name.empty() && facts->name.find('\0') == std::string::npos,
                  "an accepted name is one");
    fuzz::require(facts->serial.size() >= 16, "a serial has 16 digits at least");
  } else {
    fuzz::require_reason(facts.error());
  }
  for (const auto& host : certs::hosts_of(one))
    fuzz::require(host.size() < 65536, "a host is a part of the certificate");
  const auto text = certs::to_pem(one);
  const fuzz::memory_file again({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  fuzz::require(certs::read_certificate(again.path()).has_value(), "what is written can be read");
}

void look_at(X509_CRL& list) {
  for (const auto& serial : certs::serials_of(list))
    fuzz::require(serial.size() >= 16, "a serial has 16 digits at least");
}

template <class Result, class Look>
void judge(const Result& read, Look look) {
  if (read)
    look(*read);
  else
    fuzz::require_reason(read.error());
}

}  // namespace

/// The bytes are a file of a node: its certificate, its chain, its key, and the list of those that
/// were revoked.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::memory_file file({data, size});
  judge(certs::read_certificate(file.path()), [](const auto& one) { look_at(*one); });
  judge(certs::read_revoked(file.path()), [](const auto& list) { look_at(*list); });
  judge(certs::read_key(file.path()), [](const auto&) {});
  judge(certs::read_chain(file.path()), [](const auto& chain) {
    fuzz::require(!chain.empty(), "a chain has a certificate");
    for (const auto& one : chain)
      look_at(*one);
  });
  fuzz::require(ERR_peek_error() == 0, "no complaint of OpenSSL is left for the next caller");
  return 0;
}
