// SPDX-License-Identifier: AGPL-3.0-or-later
// What a door and a dial say and do, without CAF between them.
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "actors/links/tls_identity.hpp"
#include "tests/links/doors.hpp"
#include "tests/links/strangers.hpp"

namespace tedit::test {
namespace {

using std::chrono::milliseconds;

class Door : public Doors {
protected:
  void SetUp() override {
    Doors::SetUp();
    issued({role::solver, "worker"});
  }

  [[nodiscard]] std::unique_ptr<door> opened() {
    return value(door::open(options_of_bare_links()));
  }

  [[nodiscard]] error refusal_of(const std::string& name, std::uint16_t port,
                                 milliseconds limit = long_wait) const {
    const auto result = dialled(name, port, limit);
    EXPECT_FALSE(result.has_value());
    return result ? error{} : result.error();
  }
};

TEST_F(Door, GivesTheLinkAndSaysWhoCame) {
  const auto open = opened();
  const auto line = value(dialled("worker", open->port()));
  ASSERT_TRUE(eventually([&] { return count_came() == 1; }));

  const auto worker = value(certs::list(ca())).certificates.back();
  EXPECT_EQ(came[0].name, "worker");
  EXPECT_EQ(came[0].what, role::solver);
  EXPECT_EQ(came[0].serial, worker.serial);
  EXPECT_EQ(came[0].valid_until, worker.until);
  EXPECT_THAT(came[0].address, HasSubstr("127.0.0.1:"));
  EXPECT_EQ(line->server().name, "hall");
  EXPECT_EQ(line->server().what, role::server);
  EXPECT_TRUE(line->connected());
  ASSERT_EQ(open->peers().size(), 1U);
  EXPECT_EQ(open->peers()[0].name, "worker");
  EXPECT_EQ(total(open->refusals()), 0U);
}

TEST_F(Door, BytesComeThroughBothWaysAndAnEndEndsBoth) {
  const auto open = opened();
  const auto line = value(dialled("worker", open->port()));
  const auto mine = line->take_link();
  ASSERT_TRUE(eventually([&] { return count_came() == 1; }));
  char byte = 'a';
  ASSERT_EQ(::send(mine.get(), &byte, 1, MSG_NOSIGNAL), 1);
  ASSERT_EQ(::recv(ends[0].get(), &byte, 1, 0), 1);
  ASSERT_EQ(::send(ends[0].get(), "b", 1, MSG_NOSIGNAL), 1);
  ASSERT_EQ(::recv(mine.get(), &byte, 1, 0), 1);
  EXPECT_EQ(byte, 'b');

  ASSERT_EQ(::shutdown(ends[0].get(), SHUT_WR), 0);  // One direction alone is none.
  EXPECT_TRUE(is_ended_by_peer(mine.get()));
  EXPECT_TRUE(is_ended_by_peer(ends[0].get()));
  EXPECT_TRUE(eventually([&] { return !line->connected() && open->peers().empty(); }));
}

TEST_F(Door, WhatWasWrittenBeforeTheEndArrives) {
  const auto open = opened();
  const auto line = value(dialled("worker", open->port()));
  ASSERT_TRUE(eventually([&] { return count_came() == 1; }));
  const std::string text(150'000, 'x');
  auto mine = line->take_link();
  ASSERT_EQ(::send(mine.get(), text.data(), text.size(), MSG_NOSIGNAL),
            static_cast<ssize_t>(text.size()));
  mine.reset();
  std::string got(text.size(), '\0');
  EXPECT_EQ(::recv(ends[0].get(), got.data(), got.size(), MSG_WAITALL),
            static_cast<ssize_t>(text.size()));
}

TEST_F(Door, WhoDoesNotReadStopsWhoWritesAndNobodyElse) {
  const auto open = opened();
  const auto deaf = value(dialled("worker", open->port()));
  ASSERT_TRUE(eventually([&] { return count_came() == 1; }));
  const std::string piece(std::size_t{1} << 20, 'x');
  constexpr std::size_t most = std::size_t{128} << 20;  // What kernels buffer is far less.
  std::size_t written = 0;
  auto last = clock_type::now();
  while (written < most && clock_type::now() - last < milliseconds(500)) {
    const auto n = ::send(ends[0].get(), piece.data(), piece.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n <= 0) {
      std::this_thread::sleep_for(milliseconds(1));
      continue;
    }
    written += static_cast<std::size_t>(n);
    last = clock_type::now();
  }
  EXPECT_LT(written, most);

  issued({role::solver, "other"});
  const auto other = value(dialled("other", open->port()));
  ASSERT_TRUE(eventually([&] { return count_came() == 2; }));
  char byte = 'a';
  ASSERT_EQ(::send(ends[1].get(), &byte, 1, MSG_NOSIGNAL), 1);
  const auto others = other->take_link();
  EXPECT_EQ(::recv(others.get(), &byte, 1, 0), 1);

  const auto mine = deaf->take_link();
  std::vector<char> buffer(std::size_t{1} << 20);
  std::size_t got = 0;
  while (got < written) {
    const auto n = ::recv(mine.get(), buffer.data(), buffer.size(), 0);
    ASSERT_GT(n, 0);
    got += static_cast<std::size_t>(n);
  }
  EXPECT_EQ(got, written);
}

TEST_F(Door, FilesAreCheckedBeforeItOpens) {
  const auto refused = [&](const std::function<void(actors::door_options&)>& change) {
    auto given = options();
    change(given);
    const auto result = door::open(std::move(given));
    EXPECT_FALSE(result.has_value());
    return result ? error{} : result.error();
  };
  EXPECT_EQ(refused([&](auto& o) { o.identity = at("nowhere"); }).code, ec::io_error);
  EXPECT_EQ(refused([&](auto& o) { o.revoked = at("nowhere"); }).code, ec::io_error);
  EXPECT_EQ(refused([&](auto& o) { o.accept = nullptr; }).code, ec::invalid_argument);
  EXPECT_EQ(refused([&](auto& o) { o.address = "hall"; }).code, ec::invalid_argument);
  const auto role = refused([&](auto& o) { o.identity = at("worker"); });
  EXPECT_EQ(role.code, ec::invalid_argument);
  EXPECT_THAT(role.remedy, HasSubstr("--role server"));

  value(certs::init(at("other")));
  EXPECT_EQ(refused([&](auto& o) { o.revoked = at("other") / "crl.pem"; }).code,
            ec::invalid_argument);
  put(at("garbage"), "garbage");
  EXPECT_EQ(refused([&](auto& o) { o.revoked = at("garbage"); }).code, ec::bad_input);
  const auto own = text_of(at("hall") / "ca.crt");
  put(at("hall") / "ca.crt", text_of(at("other") / "ca.crt"));
  EXPECT_EQ(refused([](auto&) {}).code, ec::invalid_argument);
  put(at("hall") / "ca.crt", own);
  fs::permissions(at("hall") / "node.key", fs::perms(0644));
  EXPECT_THAT(refused([](auto&) {}).remedy, HasSubstr("chmod 600"));
  fs::permissions(at("hall") / "node.key", fs::perms(0600));

  const auto first = opened();
  EXPECT_EQ(refused([&](auto& o) { o.port = first->port(); }).code, ec::service_unavailable);
  const auto now = certs::now_s();
  issued({role::server, "old", {}, certs::day, now - 2 * certs::day.count()});
  EXPECT_THAT(refused([&](auto& o) { o.identity = at("old"); }).remedy, HasSubstr("certs renew"));
}

TEST_F(Door, WithoutAListOfItsOwnItTakesTheFolders) {
  auto given = options_of_bare_links();
  given.revoked.clear();
  const auto open = value(door::open(std::move(given)));
  EXPECT_TRUE(dialled("worker", open->port()).has_value());
  value(certs::revoke(ca(), {"worker", ""}));
  EXPECT_TRUE(dialled("worker", open->port()).has_value());  // It cannot know.
  fs::copy_file(ca() / "crl.pem", at("hall") / "crl.pem", fs::copy_options::overwrite_existing);
  EXPECT_FALSE(dialled("worker", open->port()).has_value());
}

TEST_F(Door, WhoIsRevokedIsToldSoWithoutARestart) {
  const auto open = opened();
  EXPECT_TRUE(dialled("worker", open->port()).has_value());
  value(certs::revoke(ca(), {"worker", ""}));
  const auto said = refusal_of("worker", open->port());
  EXPECT_EQ(said.code, ec::invalid_argument);
  EXPECT_THAT(said.message, HasSubstr("was revoked"));
  EXPECT_TRUE(eventually([&] { return count_of(*open, refusal::revoked) == 1; }));
}

TEST_F(Door, AListThatCannotBeReadLeavesTheOneBefore) {
  const auto open = opened();
  issued({role::solver, "other"});
  value(certs::revoke(ca(), {"worker", ""}));
  EXPECT_FALSE(dialled("worker", open->port()).has_value());
  const auto whole = text_of(ca() / "crl.pem");
  for (const auto& broken : {std::string(), whole.substr(0, whole.size() / 2)}) {
    put(ca() / "crl.pem", broken);
    EXPECT_FALSE(dialled("worker", open->port()).has_value());
    EXPECT_TRUE(dialled("other", open->port()).has_value());
  }
  fs::remove(ca() / "crl.pem");
  EXPECT_FALSE(dialled("worker", open->port()).has_value());
  put(ca() / "crl.pem", whole);
  EXPECT_FALSE(dialled("worker", open->port()).has_value());
  EXPECT_TRUE(dialled("other", open->port()).has_value());
}

TEST_F(Door, AnOlderListLetsNobodyInAgain) {
  const auto open = opened();
  const auto before = text_of(ca() / "crl.pem");
  value(certs::revoke(ca(), {"worker", ""}));
  EXPECT_FALSE(dialled("worker", open->port()).has_value());
  put(ca() / "crl.pem", before);
  EXPECT_EQ(refusal_of("worker", open->port()).code, ec::invalid_argument);
}

TEST_F(Door, AListOfLowerNumberIsNamedWithBothNumbers) {
  value(certs::revoke(ca(), {"worker", ""}));
  const auto newer = text_of(ca() / "crl.pem");
  auto identity = value(actors::tls_identity::load(actors::tls_side::door, {role::solver},
                                                   at("hall"), ca() / "crl.pem"));
  ASSERT_TRUE(identity.context()->list());
  const auto number = identity.context()->list()->number;
  EXPECT_EQ(number, 2);  // The authority's first list has 1.
  put(ca() / "crl.pem", text_of(at("hall") / "crl.pem"));
  const auto said = identity.look();
  ASSERT_FALSE(said);
  EXPECT_EQ(said.error().code, ec::conflict);
  EXPECT_THAT(said.error().message, HasSubstr("number 1 after 2"));
  EXPECT_TRUE(identity.context()->list()->number == 2);
  EXPECT_TRUE(identity.look()) << "said once";
  put(ca() / "crl.pem", newer);
  EXPECT_TRUE(identity.look());
}

/// The authority's list, signed anew as if a newer one should have been there an hour ago.
void make_overdue(const fs::path& ca) {
  const auto list = value(certs::read_revoked(ca / "crl.pem"));
  const auto key = value(certs::read_key(ca / certs::authority_key_file));
  const auto now = certs::now_s();
  ASN1_TIME* then = ASN1_TIME_set(nullptr, now - 7200);
  X509_CRL_set1_lastUpdate(list.get(), then);
  ASN1_TIME_set(then, now - 3600);
  X509_CRL_set1_nextUpdate(list.get(), then);
  ASN1_TIME_free(then);
  ASSERT_GT(X509_CRL_sign(list.get(), key.get(), EVP_sha256()), 0);
  put(ca / "crl.pem", certs::to_pem(*list));
}

/// What goes to stdout, where the log of a test goes, is in a file as long as this lives.
class log_in_file {
public:
  explicit log_in_file(const fs::path& file) : before_(::dup(STDOUT_FILENO)) {
    std::fflush(stdout);
    const unique_fd to(::open(file.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600));
    EXPECT_GE(::dup2(to.get(), STDOUT_FILENO), 0);
    logging::set_level("warning");
  }
  ~log_in_file() {
    logging::set_level("off");
    std::fflush(stdout);
    ::dup2(before_.get(), STDOUT_FILENO);
  }

private:
  unique_fd before_;
};

TEST_F(Door, AListThatIsOverdueHoldsAndIsToldOnce) {
  make_overdue(ca());
  const std::string words = "should have been followed by a newer one";
  const auto is_told = [&] { return text_of(at("log")).find(words) != std::string::npos; };
  auto given = options_of_bare_links();
  given.look_every = milliseconds(5);
  bool told = false;
  bool let_in = false;
  std::string why;
  {
    const log_in_file kept(at("log"));
    const auto open = value(door::open(std::move(given)));
    told = eventually(is_told);
    let_in = dialled("worker", open->port()).has_value();
    value(certs::revoke(ca(), {"worker", ""}));
    make_overdue(ca());
    why = refusal_of("worker", open->port()).message;
  }
  EXPECT_TRUE(told);
  EXPECT_TRUE(let_in);
  EXPECT_THAT(why, HasSubstr("was revoked"));
  const auto said = text_of(at("log"));
  EXPECT_EQ(said.find(words, said.find(words) + 1), std::string::npos) << said;
}

TEST_F(Door, WhoIsRevokedWhileConnectedIsCutAndOthersStay) {
  issued({role::solver, "other"});
  auto given = options_of_bare_links();
  given.look_every = milliseconds(20);
  const auto open = value(door::open(std::move(given)));
  const auto worker = value(dialled("worker", open->port()));
  const auto other = value(dialled("other", open->port()));
  ASSERT_TRUE(eventually([&] { return count_came() == 2; }));
  value(certs::revoke(ca(), {"worker", ""}));
  EXPECT_TRUE(eventually([&] { return !worker->connected(); }));
  EXPECT_TRUE(other->connected());
  ASSERT_TRUE(eventually([&] { return open->peers().size() == 1; }));
  EXPECT_EQ(open->peers()[0].name, "other");
}

TEST_F(Door, WhoseCertificateEndsWhileConnectedIsCut) {
  constexpr auto left = std::chrono::seconds(6);  // To connect on a busy machine.
  issued({role::solver, "short", {}, left, certs::now_s()});
  auto given = options_of_bare_links();
  given.look_every = milliseconds(20);
  const auto open = value(door::open(std::move(given)));
  const auto line = value(dialled("short", open->port()));
  EXPECT_TRUE(line->connected());
  EXPECT_TRUE(eventually([&] { return !line->connected(); }));
  EXPECT_TRUE(eventually([&] { return open->peers().empty(); }));
  EXPECT_THAT(refusal_of("short", open->port()).message, HasSubstr("ended at"));
}

TEST_F(Door, ADialCutsAServerThatWasRevoked) {
  const auto open = opened();
  fs::copy_file(ca() / "crl.pem", at("worker") / "crl.pem");
  const auto line =
    value(dial::connect({at("worker"), "127.0.0.1", open->port(), long_wait, milliseconds(20)}));
  EXPECT_TRUE(line->connected());
  value(certs::revoke(ca(), {"hall", ""}));
  fs::copy_file(ca() / "crl.pem", at("worker") / "crl.pem", fs::copy_options::overwrite_existing);
  EXPECT_TRUE(eventually([&] { return !line->connected(); }));
  EXPECT_THAT(refusal_of("worker", open->port()).message, HasSubstr("was revoked"));
}

TEST_F(Door, ARenewedCertificateIsShownWithoutARestart) {
  const auto open = opened();
  const auto before = value(dialled("worker", open->port()));
  const auto renewed = value(certs::renew(ca(), "hall", certs::day, at("hall")));
  const auto after = value(dialled("worker", open->port()));
  EXPECT_NE(before->server().serial, renewed.serial);
  EXPECT_EQ(after->server().serial, renewed.serial);
  EXPECT_TRUE(before->connected());
}

TEST_F(Door, RolesThatAreNotAdmittedAreToldSo) {
  issued({role::client, "person"});
  const auto open = opened();
  const auto said = refusal_of("person", open->port());
  EXPECT_EQ(said.code, ec::invalid_argument);
  EXPECT_THAT(said.message, HasSubstr("role client"));
  EXPECT_TRUE(eventually([&] { return count_of(*open, refusal::wrong_role) == 1; }));
}

TEST_F(Door, HasPlaceForSoManyLinks) {
  auto given = options_of_bare_links();
  given.most_links = 2;
  const auto open = value(door::open(std::move(given)));
  auto first = value(dialled("worker", open->port()));
  const auto second = value(dialled("worker", open->port()));
  ASSERT_TRUE(eventually([&] { return count_came() == 2; }));
  EXPECT_EQ(refusal_of("worker", open->port()).code, ec::service_unavailable);
  first.reset();
  ASSERT_TRUE(eventually([&] { return open->peers().size() == 1; }));
  EXPECT_TRUE(dialled("worker", open->port()).has_value());
}

TEST_F(Door, ItsEndCutsAllLinks) {
  auto open = opened();
  const auto first = value(dialled("worker", open->port()));
  const auto second = value(dialled("worker", open->port()));
  const auto silent = plain_connection(open->port());
  open.reset();
  EXPECT_TRUE(eventually([&] { return !first->connected() && !second->connected(); }));
  EXPECT_TRUE(is_ended_by_peer(silent.get()));
}

// -- dial ----------------------------------------------------------------------------------------

TEST_F(Door, ADialNamesAHostOfTheCertificate) {
  const auto open = opened();
  EXPECT_TRUE(dial::connect({at("worker"), "localhost", open->port(), long_wait}).has_value());
  issued({role::server, "elsewhere", {"10.1.2.3", "elsewhere.example.org"}});
  auto given = options();
  given.identity = at("elsewhere");
  const auto other = value(door::open(std::move(given)));
  for (const std::string dialled_host : {"127.0.0.1", "localhost"}) {
    const auto result = dial::connect({at("worker"), dialled_host, other->port(), long_wait});
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ec::invalid_argument);
    EXPECT_THAT(result.error().message, HasSubstr("does not hold for \"" + dialled_host + "\""));
    EXPECT_THAT(result.error().remedy, HasSubstr("--host " + dialled_host));
  }
}

TEST_F(Door, WhereNobodyListensADialSaysSo) {
  std::uint16_t free = 0;
  { free = listen_silently().port; }
  const auto said = refusal_of("worker", free);
  EXPECT_EQ(said.code, ec::service_unavailable);
  EXPECT_THAT(said.message, HasSubstr("cannot connect"));
  const auto unknown = dial::connect({at("worker"), "not..a..host", 1, long_wait});
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().code, ec::service_unavailable);
  EXPECT_THAT(unknown.error().message, HasSubstr("cannot find the host"));
}

TEST_F(Door, ADialWaitsForSilenceAsLongAsItWasToldAndNoLonger) {
  const auto silent = listen_silently();
  EXPECT_EQ(refusal_of("worker", silent.port, milliseconds(200)).code, ec::timeout);
  const auto stopped =
    dial::connect({at("worker"), "127.0.0.1", silent.port, long_wait}, cancel_token::at_poll(3));
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ec::cancelled);
}

TEST_F(Door, ADialTakesNobodyElseForAServer) {
  value(certs::init(at("other")));
  value(certs::issue(at("other"), {role::server, "hall", {"127.0.0.1"}}, at("foreign")));
  const auto now = certs::now_s();
  issued({role::server, "old", {"127.0.0.1"}, certs::day, now - 2 * certs::day.count()});
  issued({role::solver, "posing", {"127.0.0.1"}});
  const auto said = [&](tls_settings settings, const std::string& words = "tedit-1\n") {
    const tls_stranger stranger(std::move(settings), words);
    const auto result = refusal_of("worker", stranger.port());
    return std::pair(result.code, result.message);
  };
  using ::testing::Pair;
  EXPECT_THAT(said({at("foreign")}),
              Pair(ec::invalid_argument, HasSubstr("not of this node's authority")));
  EXPECT_THAT(said({at("old")}), Pair(ec::invalid_argument, HasSubstr("has ended")));
  EXPECT_THAT(said({at("posing")}), Pair(ec::invalid_argument, HasSubstr("not one of a server")));
  EXPECT_THAT(said({at("hall"), 0x0303}),
              Pair(ec::service_unavailable, HasSubstr("no node of TEdit")));
  EXPECT_THAT(said({at("hall"), 0x0304, ""}),
              Pair(ec::service_unavailable, HasSubstr("no node of TEdit")));
  EXPECT_THAT(said({at("hall"), 0x0304, "h2"}),
              Pair(ec::service_unavailable, HasSubstr("no node of TEdit")));
  EXPECT_THAT(said({at("hall")}, "HTTP/1.1 200 OK"),
              Pair(ec::service_unavailable, HasSubstr("no node of TEdit")));
  const tls_stranger good({at("hall")});
  EXPECT_TRUE(dialled("worker", good.port()).has_value());
}

}  // namespace
}  // namespace tedit::test
