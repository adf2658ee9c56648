// SPDX-License-Identifier: AGPL-3.0-or-later
// Two nodes of CAF over TLS: all that they are over an inherited pair of sockets.
#include "tests/links/doors.hpp"

namespace tedit::test {
namespace {

using namespace std::chrono_literals;

/// The least of some tries: a busy machine may hold up each of them.
constexpr int tries = 3;
constexpr auto at_once = 1s;

class Bridge : public Doors {
protected:
  void SetUp() override {
    Doors::SetUp();
    issued({role::solver, "worker"});
    open = value(door::open(options()));
  }

  std::unique_ptr<door> open;
};

TEST_F(Bridge, NodesTalk) {
  const auto worker = join("worker", open->port());
  for (int i = 0; i < 200; ++i)
    ASSERT_EQ(worker->ask(i), i + 1);
}

TEST_F(Bridge, SixtyFourMebibytesComeBackInOrder) {
  const auto worker = join("worker", open->port());
  caf::scoped_actor self(worker->node.system);
  constexpr std::size_t pieces = 64;
  std::vector<std::string> sent;
  for (std::size_t i = 0; i < pieces; ++i) {
    sent.emplace_back(std::size_t{1} << 20, static_cast<char>('a' + i % 26));
    sent.back().replace(0, 8, std::to_string(10'000'000 + i));
    self->send(worker->found, sent.back());
  }
  for (std::size_t i = 0; i < pieces; ++i) {
    bool same = false;
    self->receive([&](const std::string& text) { same = text == sent[i]; },
                  caf::after(long_wait) >> [] {});
    ASSERT_TRUE(same) << i;
  }
}

TEST_F(Bridge, OneMessageOfSixteenMebibytesPasses) {
  const auto worker = join("worker", open->port());
  const std::string large(std::size_t{16} << 20, 'x');
  caf::scoped_actor self(worker->node.system);
  bool same = false;
  self->request(worker->found, long_wait, large)
    .receive([&](const std::string& text) { same = text == large; }, [](const caf::error&) {});
  EXPECT_TRUE(same);
}

TEST_F(Bridge, TheServerSeesTheDeathOfAWorkerAtOnce) {
  auto least = clock_type::duration::max();
  for (int i = 0; i < tries; ++i) {
    auto worker = join("worker", open->port());
    const auto watched = worker->node.system.spawn(echo, std::make_shared<std::atomic<int>>(0));
    caf::scoped_actor self(worker->node.system);
    bool watches = false;
    self->request(worker->found, long_wait, watched)
      .receive([&](bool) { watches = true; }, [](const caf::error&) {});
    ASSERT_TRUE(watches);
    const int before = *seen_ends;
    const auto start = clock_type::now();
    worker->line.reset();  // As the kernel closes what a killed process had.
    ASSERT_TRUE(eventually([&] { return *seen_ends > before; }));
    least = std::min(least, clock_type::now() - start);
    caf::anon_send_exit(watched, caf::exit_reason::user_shutdown);
  }
  EXPECT_LT(least, at_once);
}

TEST_F(Bridge, AWorkerSeesTheDeathOfItsServerAtOnce) {
  auto least = clock_type::duration::max();
  for (int i = 0; i < tries; ++i) {
    const auto worker = join("worker", open->port());
    caf::scoped_actor self(worker->node.system);
    self->monitor(worker->found);
    ASSERT_EQ(worker->ask(1), 2);
    const auto start = clock_type::now();
    open.reset();
    bool told = false;
    self->receive([&](const caf::down_msg&) { told = true; }, caf::after(long_wait) >> [] {});
    ASSERT_TRUE(told);
    least = std::min(least, clock_type::now() - start);
    open = value(door::open(options()));
  }
  EXPECT_LT(least, at_once);
}

TEST_F(Bridge, WhoSendsMuchToADyingPeerLives) {
  // SIGPIPE has its default here, which would end this process.
  for (int i = 0; i < tries; ++i) {
    auto worker = join("worker", open->port());
    const std::string large(std::size_t{4} << 20, 'x');
    caf::scoped_actor self(worker->node.system);
    for (int message = 0; message < 8; ++message)
      self->send(worker->found, large);
    if (i % 2 == 0) {
      worker->line.reset();
    } else {
      open.reset();
      open = value(door::open(options()));
    }
  }
  EXPECT_EQ(join("worker", open->port())->ask(1), 2);
}

TEST_F(Bridge, TwentyNodesTalkAtOnce) {
  constexpr int nodes = 20;
  std::atomic<int> good{0};
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < nodes; ++i)
      threads.emplace_back([&, i] {
        const auto worker = join("worker", open->port());
        bool all = true;
        for (int x = 0; x < 20; ++x)
          all = all && worker->ask(100 * i + x) == 100 * i + x + 1;
        good += all;
      });
  }
  EXPECT_EQ(good, nodes);
  EXPECT_EQ(count_came(), static_cast<std::size_t>(nodes));
  EXPECT_TRUE(eventually([&] { return open->peers().empty(); }));
}

TEST_F(Bridge, AnHonestCertificateDoesNotOpenTheWayForBytesThatEndCaf) {
  const auto honest = join("worker", open->port());
  const auto line = value(dialled("worker", open->port()));
  const auto end = line->take_link();
  std::array<char, 32> bytes{1};
  ASSERT_EQ(::write(end.get(), bytes.data(), bytes.size()), 32);
  EXPECT_TRUE(eventually([&] { return !line->connected(); }));
  EXPECT_EQ(honest->ask(1), 2);
}

}  // namespace
}  // namespace tedit::test
