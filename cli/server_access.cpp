// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/server_access.hpp"

#include <cstdio>

#include <CLI/CLI.hpp>

#include "cli/config.hpp"
#include "cli/token.hpp"
#include "client/known_servers.hpp"
#include "client/server_url.hpp"
#include "tls/context.hpp"

namespace tedit::cli {

namespace {

expected<std::string> token_for(const std::string& token_file) {
  std::filesystem::path file = token_file;
  if (file.empty()) {
    const auto config = load_config({});
    if (!config)
      return fail(config.error());
    const auto usual = token_path(*config);
    if (!usual)
      return fail(usual.error());
    file = *usual;
  }
  return read_token(file);
}

/// A server that is named by its fingerprint is known from then on.
void remember_when_shown(client::server_trust& trust, const client::known_servers& known,
                         const std::string& place) {
  trust.on_certificate = [known, place, wanted = tls::read_fingerprint(trust.fingerprint)](
                           const client::server_certificate& shown) {
    if (shown.fingerprint != wanted)
      return;
    if (const auto ok = known.remember(place, wanted); !ok)
      std::fprintf(stderr, "tedit: %s\n", render(ok.error()).c_str());
  };
}

/// Errors: those of `parse_server_url` and `known_servers::find`.
expected<client::server_trust> trust_in(const std::string& url, const server_access& access) {
  client::server_trust trust;
  trust.fingerprint = access.fingerprint;
  trust.authority = access.authority;
  const auto where = client::parse_server_url(url);
  if (!where)
    return fail(where.error());
  if (!where->secure || !access.authority.empty())
    return trust;
  const auto known = client::known_servers::of_user();
  if (!known)
    return fail(known.error());
  if (!trust.fingerprint.empty()) {
    remember_when_shown(trust, *known, where->place());
    return trust;
  }
  const auto found = known->find(where->place());
  if (!found)
    return fail(found.error());
  trust.fingerprint = *found;
  return trust;
}

}  // namespace

void add_access_options(CLI::App& command, server_access& to) {
  command.add_option("--token-file", to.token_file,
                     "The token for the server; default: where \"tedit serve\" puts its own");
  auto* authority = command.add_option(
    "--server-ca", to.authority,
    "Trust a server of wss:// whose certificate the authorities of this file (PEM) issued");
  command
    .add_option(
      "--trust", to.fingerprint,
      "Trust a server of wss:// that shows the certificate of this SHA-256, now and later")
    ->excludes(authority);
}

expected<client::connect_options> reach_server(const std::string& url,
                                               const server_access& access) {
  const auto token = token_for(access.token_file);
  if (!token)
    return fail(token.error());
  auto trust = trust_in(url, access);
  if (!trust)
    return fail(trust.error());
  client::connect_options how;
  how.url = url;
  how.trust = *std::move(trust);
  how.token = *token;
  return how;
}

}  // namespace tedit::cli
