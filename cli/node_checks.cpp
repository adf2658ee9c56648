// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/node_checks.hpp"

#include <sys/timex.h>

#include <chrono>
#include <cmath>

#include "actors/links/tls_identity.hpp"
#include "actors/node/membership.hpp"
#include "actors/node/remote.hpp"
#include "base/utc.hpp"
#include "certs/make.hpp"
#include "certs/pem.hpp"
#include "cli/joining.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

/// A certificate that ends sooner should be renewed now.
constexpr auto soon = 14 * certs::day;

/// Certificates hold since an hour before they were made (certs/make.cpp): clocks may be half of
/// that apart and nobody is turned away for it.
constexpr double clocks_apart_s = 1800;

check_row failed_check(const std::string& name, const error& e) {
  return {name, false, render(e)};
}

std::string end_text(std::int64_t until) {
  const auto left = until - certs::now_s();
  return "holds until " + utc_text(until) +
         (left > 0 && left < soon.count() ? ", " + std::to_string(left / certs::day.count()) +
                                              " days: renew it (tedit certs renew)"
                                          : "");
}

check_row check_list(const std::string& where, const std::optional<certs::list_facts>& list) {
  if (!list)
    return {"revoked certificates", true, "no list"};
  const auto about =
    where + ", number " + std::to_string(list->number) + ", of " + utc_text(list->from);
  if (list->is_overdue(certs::now_s()))
    return {"revoked certificates", false,
            about + ", should have been followed by a newer one at " + utc_text(list->until) +
              "; who was revoked since is let in. Copy the newest crl.pem of the authority"};
  return {"revoked certificates", true, about};
}

/// "worker rack-1", its role and its end, from a node's folder.
expected<certs::certificate> own_certificate(const fs::path& folder) {
  return certs::read_certificate(folder / certs::node_certificate_file)
    .and_then([](const certs::x509_ptr& one) { return certs::read_facts(*one); });
}

struct server_clock {
  double ahead_s = 0;  ///< Of this machine's.
  std::string version;
};

expected<server_clock> ask_server(actors::membership& member) {
  using clock = std::chrono::system_clock;
  const auto since_1970 = [](clock::time_point when) {
    return std::chrono::duration<double>(when.time_since_epoch()).count();
  };
  const auto asked = since_1970(clock::now());
  auto facts = actors::ask_about(member.self(), member.entrance());
  if (!facts)
    return fail(facts.error());
  const auto heard = since_1970(clock::now());
  return server_clock{facts->time_s - (asked + heard) / 2, std::move(facts->version)};
}

void add_server(std::vector<check_row>& rows, actors::membership& member) {
  const auto about = ask_server(member);
  if (!about) {
    rows.push_back(failed_check("server", about.error()));
    return;
  }
  const bool fits = actors::work_together(TEDIT_VERSION, about->version);
  rows.push_back({"version", fits,
                  "TEdit " TEDIT_VERSION " here, " + about->version + " at the server" +
                    (fits ? "" : "; install versions whose minor numbers are at most one apart")});
  const auto apart = std::abs(about->ahead_s);
  const auto text = apart < 1 ? "less than a second apart"
                              : "the server's is " + std::to_string(std::lround(apart)) + " s " +
                                  (about->ahead_s > 0 ? "ahead" : "behind");
  const bool right = apart < clocks_apart_s;
  rows.push_back(
    {"clocks", right,
     text + (right ? "" : "; certificates are believed too long or not yet: set both by NTP")});
}

}  // namespace

std::vector<check_row> check_node_port(const server_config& config) {
  if (config.node_certificates.empty())
    return {{"nodes", true, "none: no other machine may work for this server"}};
  const auto identity =
    actors::tls_identity::load(actors::tls_side::door, {}, config.node_certificates);
  if (!identity)
    return {failed_check("nodes", identity.error())};
  const auto& own = identity->context()->own();
  return {{"nodes", own.until > certs::now_s(),
           config.node_certificates + ": " + own.name + " of " + identity->context()->authority() +
             " " + end_text(own.until)},
          check_list((fs::path(config.node_certificates) / certs::revoked_file).string(),
                     identity->context()->list())};
}

check_row check_clock() {
  timex state{};
  const int result = ::adjtimex(&state);
  if (result < 0)
    return {"clock", true, "whether it is kept right is not known"};
  if (result == TIME_ERROR || (state.status & STA_UNSYNC) != 0)
    return {"clock", true,
            utc_text(certs::now_s()) +
              ", not kept right by this system: see to it where several machines work together"};
  return {"clock", true,
          utc_text(certs::now_s()) + ", kept right to " +
            std::to_string((state.esterror + 999) / 1000) + " ms"};
}

std::vector<check_row> check_joining(const joining_check& what, const cancel_token& stop) {
  const auto place = parse_place(what.place);
  if (!place)
    return {failed_check("server", place.error())};
  const auto own = own_certificate(what.certificates);
  if (!own)
    return {failed_check("certificate", own.error())};
  std::vector<check_row> rows{
    {"certificate", own->until > certs::now_s(),
     own->name + ", " + std::string(certs::role_name(own->what)) + ", " + end_text(own->until)}};
  auto member = actors::membership::join(
    actors::join_place{place->host, place->port, what.certificates, TEDIT_VERSION}, stop);
  if (!member) {
    rows.push_back(failed_check("server", member.error()));
    return rows;
  }
  rows.push_back({"server", true, what.place + " is reached by TLS 1.3 and lets this node in"});
  if (own->what != certs::role::observer)
    add_server(rows, **member);
  return rows;
}

}  // namespace tedit::cli
