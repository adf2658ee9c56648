// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tls/server_identity.hpp"

#include <utility>

#include "base/utc.hpp"
#include "certs/make.hpp"
#include "certs/pem.hpp"

namespace tedit::tls {

namespace {

/// Whether a certificate may be shown now.
expected<void> check(X509& one, const std::filesystem::path& file, bool ours) {
  if (ours) {
    const auto facts = certs::read_facts(one);
    if (!facts)
      return fail(facts.error());
    if (facts->what != certs::role::server)
      return fail(ec::invalid_argument,
                  "the certificate in " + file.string() + " is of role " +
                    std::string(certs::role_name(facts->what)) + ", and clients expect a server",
                  "Issue one with --role server");
  }
  const auto until = certs::time_of(X509_get0_notAfter(&one));
  if (until <= certs::now_s())
    return fail(ec::invalid_argument,
                "the certificate in " + file.string() + " ended at " + utc_text(until),
                ours ? "Renew it: tedit certs renew" : "Have it renewed by who issued it");
  return {};
}

std::string host_text(const std::string& host) {
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

}  // namespace

expected<server_identity> server_identity::load(const std::filesystem::path& folder) {
  server_identity made;
  std::error_code code;
  made.ours_ = !std::filesystem::exists(folder / chain_file, code);
  made.certificate_ = folder / (made.ours_ ? certs::node_certificate_file : chain_file);
  made.key_ = folder / (made.ours_ ? certs::node_key_file : chain_key_file);
  if (auto ok = made.look(); !ok)
    return fail(ok.error());
  return made;
}

expected<void> server_identity::look() {
  const stamps now{stamp_of(certificate_), stamp_of(key_)};
  if (state_.how && now == seen_)
    return {};
  seen_ = now;
  auto found = read();
  if (!found)
    return fail(found.error());
  state_ = *std::move(found);
  return {};
}

expected<server_identity::state> server_identity::read() const {
  const auto chain = certs::read_chain(certificate_);
  if (!chain)
    return fail(chain.error());
  const auto key = certs::read_key(key_);
  if (!key)
    return fail(key.error());
  auto& own = *chain->front();
  if (auto ok = check(own, certificate_, ours_); !ok)
    return fail(ok.error());
  std::vector<X509*> all;
  for (const auto& one : *chain)
    all.push_back(one.get());
  auto how = context::of_server(all, **key);
  if (!how)
    return fail(how.error());
  state made{*std::move(how), fingerprint_of(own), {}, certs::time_of(X509_get0_notAfter(&own))};
  for (const auto& host : certs::hosts_of(own))
    made.hosts.push_back(host_text(host));
  return made;
}

}  // namespace tedit::tls
