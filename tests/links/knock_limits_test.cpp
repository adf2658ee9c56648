// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/knock_limits.hpp"

#include <gtest/gtest.h>

namespace tedit::actors {
namespace {

using namespace std::chrono_literals;

/// Three failures are free, then 1 s, 2 s, 4 s and no more; ten handshakes at once, one a second.
class KnockLimits : public ::testing::Test {
protected:
  static knock_rates rates() {
    knock_rates made;
    made.free_failures = 3;
    made.first_pause = 1s;
    made.longest_pause = 4s;
    made.forgotten_after = 60s;
    made.at_once = 10;
    made.per_second = 1;
    made.known_for = 1h;
    return made;
  }

  bool try_and_fail(const std::string& who) {
    const bool given = limits.admits(who, now);
    if (given)
      limits.failed(who, now);
    return given;
  }

  knock_limits limits{rates()};
  std::chrono::steady_clock::time_point now{std::chrono::hours(1)};
};

TEST_F(KnockLimits, WhoFailsWaitsTwiceAsLongEachTimeUpToTheLongest) {
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE(try_and_fail("10.0.0.7")) << i;
  for (const auto pause : {1000ms, 2000ms, 4000ms, 4000ms}) {
    now += pause - 1ms;
    EXPECT_FALSE(try_and_fail("10.0.0.7")) << pause.count();
    now += 1ms;
    EXPECT_TRUE(try_and_fail("10.0.0.7")) << pause.count();
  }
}

TEST_F(KnockLimits, OthersDoNotWaitForIt) {
  for (int i = 0; i < 5; ++i)
    static_cast<void>(try_and_fail("10.0.0.7"));
  EXPECT_FALSE(limits.admits("10.0.0.7", now));
  EXPECT_TRUE(limits.admits("10.0.0.8", now));
}

TEST_F(KnockLimits, WithoutAFailureItIsForgotten) {
  for (int i = 0; i < 4; ++i)
    static_cast<void>(try_and_fail("10.0.0.7"));
  now += 60s;
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE(try_and_fail("10.0.0.7")) << i;
  EXPECT_FALSE(try_and_fail("10.0.0.7"));
}

TEST_F(KnockLimits, WhoComesInStartsAnew) {
  for (int i = 0; i < 4; ++i)
    static_cast<void>(try_and_fail("10.0.0.7"));
  limits.came_in("10.0.0.7", now);
  EXPECT_TRUE(limits.admits("10.0.0.7", now));
}

TEST_F(KnockLimits, AllTogetherAreBoundedAndThoseWhoWorkHereComeIn) {
  limits.came_in("10.0.0.1", now);
  int given = 0;
  for (int i = 0; i < 50; ++i)
    given += limits.admits("192.0.2." + std::to_string(i), now) ? 1 : 0;
  EXPECT_EQ(given, 10);
  EXPECT_TRUE(limits.admits("10.0.0.1", now));
  now += 3s;
  given = 0;
  for (int i = 0; i < 50; ++i)
    given += limits.admits("192.0.2." + std::to_string(i), now) ? 1 : 0;
  EXPECT_EQ(given, 3);
  now += 1h;
  for (int i = 0; i < 10; ++i)
    EXPECT_TRUE(limits.admits("192.0.2.1", now));
  EXPECT_FALSE(limits.admits("10.0.0.1", now)) << "an hour after it came in";
}

TEST_F(KnockLimits, HoldsSoManyAddressesAndForgetsTheQuietestFirst) {
  for (int round = 0; round < 5; ++round)
    limits.failed("first", now);
  now += 1ms;
  for (std::size_t i = 1; i < knock_limits::most_addresses; ++i)
    limits.failed(std::to_string(i), now);
  EXPECT_FALSE(limits.admits("first", now));
  limits.failed("one more", now);
  EXPECT_TRUE(limits.admits("first", now));
}

TEST(OwnerPart, IsAnIpV4AddressOrTheFirstHalfOfAnIpV6One) {
  EXPECT_EQ(owner_part("10.0.0.7"), "10.0.0.7");
  EXPECT_EQ(owner_part("::ffff:10.0.0.7"), "10.0.0.7");
  EXPECT_EQ(owner_part("2001:db8:0:1:2:3:4:5"), "2001:db8:0:1::/64");
  EXPECT_EQ(owner_part("2001:db8:0:1::9"), "2001:db8:0:1::/64");
  EXPECT_EQ(owner_part("fe80::1%eth0"), "fe80::/64");
  EXPECT_EQ(owner_part("somebody"), "somebody");
}

}  // namespace
}  // namespace tedit::actors
