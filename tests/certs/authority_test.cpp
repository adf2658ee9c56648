// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/certs/authority_fixture.hpp"

#include <atomic>
#include <thread>

#include <openssl/x509v3.h>

namespace tedit::test {
namespace {

using certs::day;
using certs::role;

std::vector<std::string> names_of(const std::vector<certs::certificate>& all) {
  std::vector<std::string> names;
  for (const auto& one : all)
    names.push_back(one.name);
  return names;
}

TEST_F(Authority, IsForItsOwnerAlone) {
  EXPECT_EQ(mode_of(ca()), 0700U);
  EXPECT_EQ(mode_of(ca() / "issued"), 0700U);
  for (const auto& file : files_in(ca()))
    EXPECT_EQ(mode_of(ca() / file), 0600U) << file;
  EXPECT_THAT(files_in(ca()), ElementsAre("ca.crt", "ca.key", "crl.pem"));
}

TEST_F(Authority, IsNotMadeWhereSomethingIs) {
  const auto before = text_of(ca() / "ca.key");
  const auto again = certs::init(ca());
  ASSERT_FALSE(again.has_value());
  EXPECT_EQ(again.error().code, ec::conflict);
  EXPECT_THAT(again.error().message, HasSubstr(ca().string()));
  EXPECT_EQ(text_of(ca() / "ca.key"), before);

  fs::create_directory(at("empty"));
  EXPECT_TRUE(certs::init(at("empty")).has_value());
  EXPECT_EQ(mode_of(at("empty")), 0700U);

  put(at("file"), "mine");
  EXPECT_EQ(certs::init(at("file")).error().code, ec::conflict);
  EXPECT_EQ(text_of(at("file")), "mine");
  EXPECT_EQ(certs::init(at("no") / "where").error().code, ec::io_error);
}

TEST_F(Authority, NamesAreCheckedBeforeAnythingIsWritten) {
  EXPECT_EQ(certs::init(at("new"), "").error().code, ec::invalid_argument);
  EXPECT_EQ(certs::init(at("new"), "a\nb").error().code, ec::invalid_argument);
  EXPECT_EQ(certs::init(at("new"), std::string(64, 'a')).error().code, ec::invalid_argument);
  EXPECT_EQ(certs::init(at("new"), "TEdit", 8000 * day).error().code, ec::invalid_argument);
  for (const std::string name :
       {"", "a b", "a,DNS:b", "../up", "-x", ".x", "*", "a/b", "a\nb", "ä"})
    EXPECT_EQ(certs::issue(ca(), {role::solver, name}, at("out")).error().code,
              ec::invalid_argument)
      << name;
  for (const std::string host : {"", "*.example.org", "a,IP:1.2.3.4", "10.0.0.0/8 ", "host:80"})
    EXPECT_EQ(certs::issue(ca(), {role::server, "s", {host}}, at("out")).error().code,
              ec::invalid_argument)
      << host;
  EXPECT_FALSE(fs::exists(at("out")));
  EXPECT_THAT(files_in(ca()), ElementsAre("ca.crt", "ca.key", "crl.pem"));
}

TEST_F(Authority, ANodesFolderHoldsWhatItNeedsAndNoMore) {
  const auto worker = issued({role::solver, "solver-1"});
  EXPECT_THAT(files_in(at("solver-1")), ElementsAre("ca.crt", "node.crt", "node.key"));
  const auto server = issued({role::server, "hall", {"hall.example.org", "10.0.0.7", "::1"}});
  EXPECT_THAT(files_in(at("hall")), ElementsAre("ca.crt", "crl.pem", "node.crt", "node.key"));
  for (const auto& name : {"solver-1", "hall"}) {
    EXPECT_EQ(mode_of(at(name)), 0700U);
    for (const auto& file : files_in(at(name)))
      EXPECT_EQ(mode_of(at(name) / file), 0600U) << file;
  }
  EXPECT_EQ(worker.what, role::solver);
  EXPECT_EQ(worker.serial.size(), 16U);
  EXPECT_THAT(worker.hosts, ElementsAre("solver-1"));
  EXPECT_THAT(server.hosts, ElementsAre("hall", "hall.example.org", "10.0.0.7", "::1"));
  EXPECT_NE(worker.serial, server.serial);
}

TEST_F(Authority, CertificatesSayWhatTheyAreFor) {
  issued({role::server, "hall", {"10.0.0.7"}});
  const auto one = value(certs::read_certificate(at("hall") / "node.crt"));
  const auto key = value(certs::read_key(at("hall") / "node.key"));
  const auto own = value(certs::read_certificate(ca() / "ca.crt"));
  EXPECT_EQ(X509_verify(one.get(), X509_get0_pubkey(own.get())), 1);
  EXPECT_EQ(X509_check_private_key(one.get(), key.get()), 1);
  EXPECT_EQ(EVP_PKEY_get_bits(key.get()), 256);
  EXPECT_EQ(X509_check_ca(one.get()), 0);
  EXPECT_EQ(X509_check_ca(own.get()), 1);
  EXPECT_EQ(X509_check_purpose(one.get(), X509_PURPOSE_SSL_SERVER, 0), 1);
  EXPECT_EQ(X509_check_purpose(one.get(), X509_PURPOSE_SSL_CLIENT, 0), 0);
  EXPECT_EQ(X509_check_ip_asc(one.get(), "10.0.0.7", 0), 1);
  EXPECT_EQ(X509_check_ip_asc(one.get(), "10.0.0.8", 0), 0);
  EXPECT_EQ(X509_check_host(one.get(), "hall", 0, 0, nullptr), 1);
  EXPECT_EQ(X509_check_host(one.get(), "wall", 0, 0, nullptr), 0);
}

TEST_F(Authority, EveryRoleComesBackFromItsCertificate) {
  for (const auto& row : certs::all_roles)
    EXPECT_EQ(issued({row.value, std::string(row.name)}).what, row.value);
  EXPECT_EQ(value(certs::list(ca())).certificates.size(), certs::all_roles.size());
  EXPECT_FALSE(certs::role_named("admin").has_value());
}

TEST_F(Authority, ACertificateHoldsForTheDaysItWasGiven) {
  const auto now = certs::now_s();
  const auto one = issued({role::solver, "s", {}, 30 * day});
  EXPECT_GE(one.until, now + 30 * day.count());
  EXPECT_LE(one.until, certs::now_s() + 30 * day.count());
  EXPECT_LE(one.from, now - 3599);  // Clocks differ.
  const auto beyond = certs::issue(ca(), {role::solver, "t", {}, 4000 * day}, at("t"));
  EXPECT_EQ(beyond.error().code, ec::invalid_argument);
  EXPECT_THAT(beyond.error().remedy, HasSubstr("days are left"));
  EXPECT_EQ(certs::issue(ca(), {role::solver, "t", {}, 0 * day}, at("t")).error().code,
            ec::invalid_argument);
}

TEST_F(Authority, ANameHasOneCertificateThatHolds) {
  issued({role::solver, "s"});
  const auto second = certs::issue(ca(), {role::solver, "s"}, at("other"));
  EXPECT_EQ(second.error().code, ec::conflict);
  EXPECT_FALSE(fs::exists(at("other")));

  value(certs::revoke(ca(), {"s", ""}));
  EXPECT_TRUE(certs::issue(ca(), {role::solver, "s"}, at("other")).has_value());
  const auto now = certs::now_s();
  issued({role::solver, "ended", {}, day, now - 2 * day.count()});
  EXPECT_TRUE(certs::issue(ca(), {role::solver, "ended"}, at("again")).has_value());
}

TEST_F(Authority, NothingIsOverwritten) {
  fs::create_directory(at("s"));
  put(at("s") / "notes", "mine");
  const auto issued_there = certs::issue(ca(), {role::solver, "s"}, at("s"));
  EXPECT_EQ(issued_there.error().code, ec::conflict);
  EXPECT_THAT(files_in(at("s")), ElementsAre("notes"));
  EXPECT_THAT(value(certs::list(ca())).certificates, IsEmpty());
  EXPECT_EQ(certs::issue(ca(), {role::solver, "s"}, at("no") / "where").error().code, ec::io_error);
  // Nothing half-written is left beside.
  EXPECT_THAT(files_in(folder.path()),
              ElementsAre("ca/ca.crt", "ca/ca.key", "ca/crl.pem", "s/notes"));
}

TEST_F(Authority, RenewingExchangesTheFolderInOneStep) {
  const auto first = issued({role::server, "hall", {"10.0.0.7"}, 10 * day});
  const auto key = text_of(at("hall") / "node.key");

  const auto second = value(certs::renew(ca(), "hall", 365 * day, at("hall")));

  EXPECT_EQ(second.what, role::server);
  EXPECT_THAT(second.hosts, ElementsAre("hall", "10.0.0.7"));
  EXPECT_GT(second.until, first.until);
  EXPECT_NE(second.serial, first.serial);
  EXPECT_NE(text_of(at("hall") / "node.key"), key);
  EXPECT_EQ(
    value(certs::read_facts(*value(certs::read_certificate(at("hall") / "node.crt")))).serial,
    second.serial);
  EXPECT_EQ(value(certs::list(ca())).certificates.size(), 2U);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST_F(Authority, RenewingTakesNobodyElsesFolder) {
  issued({role::solver, "a"});
  issued({role::solver, "b"});
  EXPECT_EQ(certs::renew(ca(), "a", day, at("b")).error().code, ec::conflict);
  put(at("a") / "notes", "mine");
  EXPECT_EQ(certs::renew(ca(), "a", day, at("a")).error().code, ec::conflict);
  EXPECT_EQ(text_of(at("a") / "notes"), "mine");
  EXPECT_TRUE(certs::renew(ca(), "a", day, at("new")).has_value());
  EXPECT_EQ(certs::renew(ca(), "c", day, at("c")).error().code, ec::not_found);
  value(certs::revoke(ca(), {"b", ""}));
  EXPECT_EQ(certs::renew(ca(), "b", day, at("b")).error().code, ec::conflict);
}

TEST_F(Authority, WhoIsRevokedStandsOnTheList) {
  const auto a = issued({role::solver, "a"});
  const auto b = issued({role::solver, "b"});
  issued({role::client, "c"});

  EXPECT_THAT(names_of(value(certs::revoke(ca(), {"a", ""}))), ElementsAre("a"));
  EXPECT_THAT(names_of(value(certs::revoke(ca(), {"", b.serial}))), ElementsAre("b"));

  const auto crl = value(certs::read_revoked(ca() / "crl.pem"));
  EXPECT_EQ(certs::serials_of(*crl), (std::set<std::string>{a.serial, b.serial}));
  EXPECT_EQ(mode_of(ca() / "crl.pem"), 0600U);
  const auto all = value(certs::list(ca())).certificates;
  EXPECT_TRUE(all[0].revoked);
  EXPECT_TRUE(all[1].revoked);
  EXPECT_FALSE(all[2].revoked);
  EXPECT_EQ(certs::revoke(ca(), {"a", ""}).error().code, ec::conflict);
  EXPECT_EQ(certs::revoke(ca(), {"", b.serial}).error().code, ec::conflict);
  EXPECT_EQ(certs::revoke(ca(), {"d", ""}).error().code, ec::not_found);
  EXPECT_EQ(certs::revoke(ca(), {"", "0123"}).error().code, ec::not_found);
}

TEST_F(Authority, RevokingANameEndsAllOfItsCertificates) {
  issued({role::solver, "a"});
  value(certs::renew(ca(), "a", day, at("a")));
  EXPECT_EQ(value(certs::revoke(ca(), {"a", ""})).size(), 2U);
}

TEST_F(Authority, CallsAtOnceTakeTurns) {
  std::vector<std::string> names;
  for (int i = 0; i < 8; ++i)
    names.push_back("node-" + std::to_string(i));
  {
    std::vector<std::jthread> threads;
    for (const auto& name : names)
      threads.emplace_back([&, name] {
        issued({role::solver, name});
        value(certs::revoke(ca(), {name, ""}));
      });
  }
  const auto all = value(certs::list(ca())).certificates;
  EXPECT_EQ(names_of(all), names);
  for (const auto& one : all)
    EXPECT_TRUE(one.revoked) << one.name;
}

TEST_F(Authority, TwoThatWantOneNameAtOnceGetOneCertificate) {
  std::atomic<int> made{0};
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 6; ++i)
      threads.emplace_back([&] {
        made += certs::issue(ca(), {role::solver, "one"}, at("one")).has_value();
      });
  }
  EXPECT_EQ(made, 1);
  EXPECT_EQ(value(certs::list(ca())).certificates.size(), 1U);
}

}  // namespace
}  // namespace tedit::test
