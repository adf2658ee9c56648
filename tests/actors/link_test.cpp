// SPDX-License-Identifier: AGPL-3.0-or-later
// Two nodes of CAF over a link, and peers that do not keep to the protocol.
#include "actors/links/link.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ringbuffer_sink.h>
#include <spdlog/spdlog.h>
#include <caf/event_based_actor.hpp>
#include <caf/scoped_actor.hpp>
#include <caf/send.hpp>

#include "actors/exits.hpp"
#include "actors/node/system_config.hpp"

namespace tedit::actors {
namespace {

constexpr auto patience = std::chrono::seconds(20);

/// A node of its own.
struct node {
  system_config config{true};
  caf::actor_system system{config};
};

/// Of any numbers: mutated bytes ask for many.
int times(int a, int b) {
  return static_cast<int>(static_cast<unsigned>(a) * static_cast<unsigned>(b));
}

/// With an argument: CAF 0.17 dereferences a null pointer when it starts a function without any.
caf::behavior multiplier(caf::event_based_actor* self, int factor) {
  heed_only_own_exits(self);
  return {[=](int x) { return times(factor, x); }};
}

/// Ends by whoever asks it to, as CAF's actors do.
caf::behavior weak_multiplier(caf::event_based_actor*, int factor) {
  return {[=](int x) { return times(factor, x); }};
}

caf::behavior linked_to(caf::event_based_actor* self, const caf::actor& peer) {
  // The server may cut the link, and so end the peer, before this one is asked.
  self->set_exit_handler([](const caf::exit_msg&) {});
  self->link_to(peer);
  return {[](int x) { return x; }};
}

/// Says who else is there.
caf::behavior tattler(caf::event_based_actor* self, const caf::actor& other) {
  heed_only_own_exits(self);
  return {[=](int) { return other; }};
}

int ask(caf::actor_system& system, const caf::actor& whom, int x) {
  int result = -1;
  caf::scoped_actor self(system);
  self->request(whom, patience, x).receive([&](int y) { result = y; }, [](const caf::error&) {});
  return result;
}

class Link : public ::testing::Test {
protected:
  node host;
  caf::actor enlister = host.system.spawn(multiplier, 2);

  Link() { spdlog::set_level(spdlog::level::off); }
  ~Link() override {
    caf::anon_send_exit(enlister, caf::exit_reason::user_shutdown);
    spdlog::set_level(spdlog::level::info);
  }

  unique_fd served(const caf::actor& whom, reach others = reach_of({})) {
    auto link = make_link();
    EXPECT_TRUE(link.has_value());
    serve_link(host.system, std::move(link->ours), whom, std::move(others));
    return std::move(link->theirs);
  }

  /// Whether the host ended the connection; reads what comes until then.
  static bool is_cut(int fd) {
    std::array<char, 4096> buffer{};
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < deadline) {
      pollfd wait{fd, POLLIN, 0};
      if (poll(&wait, 1, 100) > 0 && recv(fd, buffer.data(), buffer.size(), 0) <= 0)
        return true;
    }
    return false;
  }

  /// An honest node gets answers still.
  void expect_others_are_served() {
    node other;
    const auto found = join_link(other.system, served(enlister));
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(ask(other.system, *found, 21), 42);
  }
};

TEST_F(Link, JoinedNodesTalk) {
  expect_others_are_served();
}

// A busy machine takes longer to start a process than a node that fell silent is given.
TEST_F(Link, WhoIsSlowToStartJoinsAllTheSame) {
  auto end = served(enlister);
  std::this_thread::sleep_for(std::chrono::seconds(8));  // Silent for 5 s: gone.
  node worker;
  const auto found = join_link(worker.system, std::move(end));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(ask(worker.system, *found, 21), 42);
}

TEST_F(Link, WhoJoinsHearsOfTheEndOfTheOther) {
  node worker;
  const auto found = join_link(worker.system, served(enlister));
  ASSERT_TRUE(found.has_value());
  caf::scoped_actor self(worker.system);
  self->monitor(*found);
  caf::anon_send_exit(enlister, caf::exit_reason::user_shutdown);
  bool told = false;
  self->receive([&](const caf::down_msg&) { told = true; }, caf::after(patience) >> [] {});
  EXPECT_TRUE(told);
}

TEST_F(Link, WithoutAServerJoiningFailsWithAReason) {
  node worker;
  auto link = make_link();
  link->ours.reset();
  const auto found = join_link(worker.system, std::move(link->theirs));
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ec::service_unavailable);
}

TEST_F(Link, WhoIsToEndDoesNotWaitForAServerThatIsSilent) {
  node worker;
  auto link = make_link();  // Its other end is open, and nobody serves it.
  const auto found = join_link(worker.system, std::move(link->theirs), cancel_token::at_poll(2));
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ec::cancelled);
}

TEST_F(Link, ThirtyTwoBytesDoNotEndTheServer) {
  const auto fd = served(enlister);
  std::array<char, 32> bytes{1};
  ASSERT_EQ(send(fd.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL), 32);
  EXPECT_TRUE(is_cut(fd.get()));
  expect_others_are_served();
}

/// Once is said why a link is cut, however much the other end has sent by then.
TEST_F(Link, WhatCameBehindABreachIsNotLookedAt) {
  const auto said = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(100);
  const auto usual = spdlog::default_logger();
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("link", said));
  const auto fd = served(enlister);
  const std::vector<char> bytes(std::size_t{32} * 20, -1);  // No header is like this.
  const auto size = static_cast<ssize_t>(bytes.size());
  ASSERT_EQ(send(fd.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL), size);
  EXPECT_TRUE(is_cut(fd.get()));
  expect_others_are_served();  // The same thread has come as far.
  spdlog::set_default_logger(usual);

  const auto lines = said->last_formatted();
  EXPECT_EQ(std::ranges::count_if(
              lines, [](const auto& line) { return line.find("broke the protocol") != line.npos; }),
            1)
    << ::testing::PrintToString(lines);
}

TEST_F(Link, AHeaderThatClaimsFourGigabytesGetsNone) {
  const auto fd = served(enlister);
  std::array<unsigned char, 32> bytes{1, 0, 0, 0, 0xff, 0xff, 0xff, 0xff};
  ASSERT_EQ(send(fd.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL), 32);
  EXPECT_TRUE(is_cut(fd.get()));
}

TEST_F(Link, AnExitMessageCutsTheLinkAndEndsNobody) {
  const auto weak = host.system.spawn(weak_multiplier, 2);
  node worker;
  const auto found = join_link(worker.system, served(weak));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(ask(worker.system, *found, 1), 2);

  caf::anon_send_exit(*found, caf::exit_reason::kill);

  caf::scoped_actor self(worker.system);
  self->monitor(*found);
  bool cut = false;
  self->receive([&](const caf::down_msg&) { cut = true; }, caf::after(patience) >> [] {});
  EXPECT_TRUE(cut);
  EXPECT_EQ(ask(host.system, weak, 3), 6);
  caf::anon_send_exit(weak, caf::exit_reason::user_shutdown);
}

TEST_F(Link, OnlyActorsWithinReachCanBeSentTo) {
  const auto gossip = host.system.spawn(tattler, enlister);
  const auto told = [](caf::actor_system& system, const caf::actor& whom) {
    caf::actor other;
    caf::scoped_actor self(system);
    self->request(whom, patience, 0)
      .receive([&](const caf::actor& found) { other = found; }, [](const caf::error&) {});
    return other;
  };
  {
    node worker;
    const auto found = join_link(worker.system, served(gossip, reach_of({enlister})));
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(ask(worker.system, told(worker.system, *found), 21), 42);
  }
  {
    node worker;
    const auto found = join_link(worker.system, served(gossip));
    ASSERT_TRUE(found.has_value());
    const auto other = told(worker.system, *found);
    caf::scoped_actor self(worker.system);
    self->monitor(*found);
    self->send(other, 21);  // It is not for this node, which is cut off, and gets no answer.
    bool cut = false;
    bool waits = true;
    int answer = -1;
    while (waits && !cut)
      self->receive([&](const caf::down_msg&) { cut = true; }, [&](int y) { answer = y; },
                    caf::after(patience) >> [&] { waits = false; });
    EXPECT_TRUE(cut);
    EXPECT_EQ(answer, -1);
  }
  expect_others_are_served();
  caf::anon_send_exit(gossip, caf::exit_reason::user_shutdown);
}

TEST_F(Link, ANodeThatLinksItselfToAnActorAndDiesTakesNobodyWithIt) {
  auto worker = std::make_unique<node>();
  const auto found = join_link(worker->system, served(enlister));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(ask(worker->system, *found, 1), 2);
  const auto linked = worker->system.spawn(linked_to, *found);
  EXPECT_EQ(ask(worker->system, linked, 5), 5);
  caf::anon_send_exit(linked, caf::exit_reason::kill);
  worker.reset();

  expect_others_are_served();
}

/// Conversations as an honest node begins them, with some bytes changed, cut off or put in.
TEST_F(Link, MutatedConversationsEndNothing) {
  std::vector<std::vector<char>> starts;
  {
    // What an honest node says: its greeting and a request.
    auto link = make_link();
    auto between = make_link();
    serve_link(host.system, std::move(link->ours), enlister);
    node worker;
    std::vector<char> said;
    std::jthread relay([&](const std::stop_token& stop) {
      std::array<char, 65536> buffer{};
      while (!stop.stop_requested()) {
        std::array<pollfd, 2> both{pollfd{link->theirs.get(), POLLIN, 0},
                                   pollfd{between->ours.get(), POLLIN, 0}};
        if (poll(both.data(), 2, 50) <= 0)
          continue;
        for (std::size_t i = 0; i < 2; ++i) {
          if (both[i].revents == 0)
            continue;
          const auto n = recv(both[i].fd, buffer.data(), buffer.size(), 0);
          if (n <= 0)
            return;
          if (i == 1)
            said.insert(said.end(), buffer.data(), buffer.data() + n);
          send(both[1 - i].fd, buffer.data(), static_cast<std::size_t>(n), MSG_NOSIGNAL);
        }
      }
    });
    const auto found = join_link(worker.system, std::move(between->theirs));
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(ask(worker.system, *found, 4), 8);
    relay.request_stop();
    relay.join();
    ASSERT_GT(said.size(), 100U);
    starts.push_back(std::move(said));
  }
  const char* wanted = std::getenv("TEDIT_LINK_MUTATIONS");
  const int rounds = wanted ? std::atoi(wanted) : 300;
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int round = 0; round < rounds; ++round) {
    auto bytes = starts[below(starts.size())];
    for (auto changes = 1 + below(4); changes > 0; --changes)
      bytes[below(round % 2 == 0 ? 96 : bytes.size())] = static_cast<char>(random());
    if (below(3) == 0)
      bytes.resize(below(bytes.size()) + 1);
    const auto fd = served(enlister);
    send(fd.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (round % 50 == 0) {
      ASSERT_EQ(ask(host.system, enlister, round), 2 * round);
    }
  }
  expect_others_are_served();
}

}  // namespace
}  // namespace tedit::actors
