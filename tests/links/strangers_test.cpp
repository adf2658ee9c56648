// SPDX-License-Identifier: AGPL-3.0-or-later
// Who is not invited, while an honest worker stays connected through all of it.
#include "tests/links/strangers.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <random>

#include "tests/links/doors.hpp"

namespace tedit::test {
namespace {

using namespace std::chrono_literals;

class Strangers : public Doors {
protected:
  void SetUp() override {
    Doors::SetUp();
    issued({role::solver, "honest"});
  }

  /// What strangers do here is more than an address may: that is tested by itself.
  void open_door(actors::door_options given) {
    given.knocks.free_failures = 1'000'000;
    given.knocks.at_once = 1'000'000;
    open = value(door::open(std::move(given)));
    honest = join("honest", open->port());
  }

  void TearDown() override {
    EXPECT_TRUE(honest->line->connected());
    EXPECT_EQ(honest->ask(41), 42);
    EXPECT_TRUE(eventually([&] { return count_came() == expected_links; })) << count_came();
  }

  /// How many were turned away for this reason.
  [[nodiscard]] std::uint64_t refused(refusal why) const { return count_of(*open, why); }

  /// The door says nothing to it, and counts it so.
  void expect_refused(const tls_settings& settings, refusal why) {
    const auto before = refused(why);
    EXPECT_EQ(first_words(open->port(), settings), "") << actors::refusal_text(why);
    EXPECT_TRUE(eventually([&] { return refused(why) == before + 1; }))
      << actors::refusal_text(why);
  }

  /// How long it takes to dial, the least of three tries.
  [[nodiscard]] clock_type::duration time_to_come_in() {
    auto least = clock_type::duration::max();
    for (int i = 0; i < 3; ++i) {
      const auto start = clock_type::now();
      const auto line = value(dialled("honest", open->port()));
      least = std::min(least, clock_type::now() - start);
      ++expected_links;
    }
    return least;
  }

  /// What a node says when it joins and asks, in BASP.
  [[nodiscard]] std::string recorded_conversation() {
    auto link = value(actors::make_link());
    auto between = value(actors::make_link());
    actors::serve_link(host.system, std::move(link.ours), enlister);
    caf_node worker;
    std::string said;
    std::jthread relay([&](const std::stop_token& stop) {
      std::array<char, 65536> buffer{};
      while (!stop.stop_requested()) {
        std::array<pollfd, 2> both{pollfd{link.theirs.get(), POLLIN, 0},
                                   pollfd{between.ours.get(), POLLIN, 0}};
        if (::poll(both.data(), 2, 50) <= 0)
          continue;
        for (std::size_t i = 0; i < 2; ++i) {
          const auto n =
            both[i].revents != 0 ? ::recv(both[i].fd, buffer.data(), buffer.size(), 0) : 0;
          if (n > 0 && i == 1)
            said.append(buffer.data(), static_cast<std::size_t>(n));
          if (n > 0)
            ::send(both[1 - i].fd, buffer.data(), static_cast<std::size_t>(n), MSG_NOSIGNAL);
        }
      }
    });
    const auto found = value(actors::join_link(worker.system, std::move(between.theirs)));
    caf::scoped_actor self(worker.system);
    self->request(found, long_wait, 1).receive([](int) {}, [](const caf::error&) {});
    relay.request_stop();
    relay.join();
    return said;
  }

  /// The first bytes of a dial.
  [[nodiscard]] std::string recorded_hello() const {
    const auto silent = listen_silently();
    std::jthread caller([&] { static_cast<void>(dialled("honest", silent.port, 500ms)); });
    const unique_fd guest(::accept4(silent.socket.get(), nullptr, nullptr, SOCK_CLOEXEC));
    std::string hello(4096, '\0');
    const auto n = ::recv(guest.get(), hello.data(), hello.size(), 0);
    hello.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    return hello;
  }

  /// Connections of these bytes with some changed, cut off at times; each is counted once.
  void send_mutated(const std::string& bytes, int rounds) {
    ASSERT_GT(bytes.size(), 100U);
    const auto before = total(open->refusals());
    std::mt19937 random(7);
    const auto below = [&](std::size_t n) { return random() % n; };
    for (int round = 0; round < rounds; ++round) {
      auto mutated = bytes;
      for (auto changes = 1 + below(4); changes > 0; --changes)
        mutated[below(round % 2 == 0 ? 96 : mutated.size())] = static_cast<char>(random());
      if (below(3) == 0)
        mutated.resize(below(mutated.size()) + 1);
      const auto fd = plain_connection(open->port());
      ASSERT_TRUE(fd);
      ::send(fd.get(), mutated.data(), mutated.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (round % 200 == 0) {
        ASSERT_EQ(honest->ask(round), round + 1);
      }
    }
    EXPECT_TRUE(eventually(
      [&] { return total(open->refusals()) == before + static_cast<std::uint64_t>(rounds); }))
      << total(open->refusals()) - before;
  }

  std::unique_ptr<door> open;
  std::unique_ptr<joined_node> honest;
  std::size_t expected_links = 1;

private:
  pipe_signal_ignored ignored_;
};

TEST_F(Strangers, TheBytesThatEndCafDoNotReachIt) {
  open_door(options());
  const auto fd = plain_connection(open->port());
  std::array<char, 32> bytes{1};
  ASSERT_EQ(::send(fd.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL), 32);
  EXPECT_TRUE(is_ended_by_peer(fd.get()));
  EXPECT_TRUE(eventually([&] { return refused(refusal::not_tls) == 1; }));
}

TEST_F(Strangers, TwoThousandMutatedConversationsEndNothing) {
  open_door(options());
  send_mutated(recorded_conversation(), 2000);
}

TEST_F(Strangers, FiveHundredMutatedHellosEndNothing) {
  auto given = options();
  given.handshake_limit = 500ms;  // Of those who are asked for more and have left.
  open_door(std::move(given));
  send_mutated(recorded_hello(), 500);
}

TEST_F(Strangers, TwoHundredWhoAreSilentKeepNobodyOut) {
  open_door(options());
  std::vector<unique_fd> silent;
  for (int i = 0; i < 200; ++i) {
    silent.push_back(plain_connection(open->port()));
    ASSERT_TRUE(silent.back());
  }
  EXPECT_LT(time_to_come_in(), 1s);
  // All but those that may wait at once have gone.
  EXPECT_TRUE(
    eventually([&] { return refused(refusal::crowded) + refused(refusal::silent) >= 200 - 64; }));
}

TEST_F(Strangers, WhoIsSilentIsCutWhenItsTimeIsOver) {
  auto given = options();
  given.handshake_limit = 500ms;
  open_door(std::move(given));
  const auto fd = plain_connection(open->port());
  EXPECT_TRUE(is_ended_by_peer(fd.get()));
  EXPECT_TRUE(eventually([&] { return refused(refusal::silent) == 1; }));
}

TEST_F(Strangers, WhoSaysHalfAHelloIsAsSilent) {
  auto given = options();
  given.handshake_limit = 500ms;
  open_door(std::move(given));
  const auto hello = recorded_hello();
  const auto fd = plain_connection(open->port());
  ASSERT_GT(::send(fd.get(), hello.data(), hello.size() / 2, MSG_NOSIGNAL), 0);
  EXPECT_LT(time_to_come_in(), 1s);
  EXPECT_TRUE(is_ended_by_peer(fd.get()));
}

TEST_F(Strangers, OlderTlsIsRefused) {
  open_door(options());
  expect_refused({at("honest"), 0x0303}, refusal::old_tls);
}

TEST_F(Strangers, WithoutACertificateNobodyComesIn) {
  open_door(options());
  expect_refused({}, refusal::no_certificate);
}

TEST_F(Strangers, CertificatesOfOthersOpenNothing) {
  open_door(options());
  value(certs::init(at("other")));  // The same name as ours has.
  value(certs::issue(at("other"), {role::solver, "honest"}, at("foreign")));
  expect_refused({at("foreign")}, refusal::other_authority);

  fs::create_directory(at("self"));
  fs::copy_file(at("other") / "ca.crt", at("self") / "node.crt");
  fs::copy_file(at("other") / "ca.key", at("self") / "node.key");
  expect_refused({at("self")}, refusal::other_authority);
}

TEST_F(Strangers, CertificatesThatHaveEndedOrNotBegunOpenNothing) {
  open_door(options());
  const auto now = certs::now_s();
  issued({role::solver, "old", {}, certs::day, now - 2 * certs::day.count()});
  expect_refused({at("old")}, refusal::ended);
  issued({role::solver, "early", {}, certs::day, now + 2 * certs::day.count()});
  expect_refused({at("early")}, refusal::ended);
}

TEST_F(Strangers, RevokedOnesAndOtherRolesAreRefused) {
  open_door(options());
  issued({role::solver, "former"});
  EXPECT_EQ(first_words(open->port(), {at("former")}), "tedit-1\n");
  ++expected_links;
  value(certs::revoke(ca(), {"former", ""}));
  expect_refused({at("former")}, refusal::revoked);
  issued({role::client, "client"});
  expect_refused({at("client")}, refusal::wrong_role);
  expect_refused({at("hall")}, refusal::wrong_role);
}

TEST_F(Strangers, OtherServicesAreNotTalkedTo) {
  open_door(options());
  expect_refused({at("honest"), 0x0304, "h2"}, refusal::not_a_node);
  expect_refused({at("honest"), 0x0304, ""}, refusal::not_a_node);
}

TEST_F(Strangers, WhoFailsAgainAndAgainIsGivenNoHandshake) {
  auto given = options();
  given.knocks.free_failures = 2;
  given.knocks.first_pause = given.knocks.longest_pause = std::chrono::minutes(10);
  given.knocks.forgotten_after = std::chrono::hours(1);
  open = value(door::open(std::move(given)));
  honest = join("honest", open->port());
  for (int i = 0; i < 3; ++i)
    expect_refused({}, refusal::no_certificate);
  expect_refused({}, refusal::too_often);
  EXPECT_FALSE(dialled("honest", open->port()).has_value());  // Of the same address.
  EXPECT_TRUE(eventually([&] { return refused(refusal::too_often) == 2; }));
}

TEST_F(Strangers, WhoOnlyLooksWhetherThePortIsOpenMayComeIn) {
  auto given = options();
  given.knocks.free_failures = 0;
  given.knocks.first_pause = given.knocks.longest_pause = std::chrono::minutes(10);
  open = value(door::open(std::move(given)));
  honest = join("honest", open->port());
  for (int i = 0; i < 20; ++i)
    ASSERT_TRUE(plain_connection(open->port()));
  EXPECT_TRUE(eventually([&] { return refused(refusal::gone) == 20; }));
  EXPECT_LT(time_to_come_in(), 10s);
}

TEST_F(Strangers, AHundredRefusedHandshakesDisturbNoHonestOne) {
  open_door(options());
  std::atomic<bool> over{false};
  std::atomic<int> refused_ones{0};
  std::vector<std::jthread> threads;
  for (int i = 0; i < 2; ++i)
    threads.emplace_back([&] {
      for (int round = 0; round < 50; ++round)
        refused_ones += first_words(open->port(), {}).empty();
      over = true;
    });
  int asked = 0;
  while (!over) {
    ASSERT_EQ(honest->ask(asked), asked + 1);
    ++asked;
  }
  threads.clear();
  EXPECT_EQ(refused_ones, 100);
  EXPECT_GT(asked, 0);
}

}  // namespace
}  // namespace tedit::test
