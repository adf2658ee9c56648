// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/time_limit.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace tedit {
namespace {

/// Waits until the token is cancelled; the test's own time ends it where that never happens.
void wait_for(const cancel_token& token) {
  while (!token.cancelled())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(TimeLimit, WorkEndsWithTheTimeAndWhoeverAskedGoesOn) {
  const cancel_token asked;
  const time_limit limit(asked, .05);
  EXPECT_FALSE(limit.is_over());

  wait_for(limit.token());

  EXPECT_TRUE(limit.is_over());
  EXPECT_FALSE(asked.cancelled());
}

TEST(TimeLimit, ACancelOfWhoeverAskedReachesTheWorkBeforeTheTime) {
  const cancel_token asked;
  const time_limit limit(asked, 1e300);
  EXPECT_FALSE(limit.token().cancelled());

  asked.cancel();
  wait_for(limit.token());

  EXPECT_FALSE(limit.is_over());
}

TEST(TimeLimit, NoTimeIsOverAtOnce) {
  for (const double seconds : {0.0, -1.0})
    EXPECT_TRUE(time_limit(cancel_token(), seconds).token().cancelled()) << seconds;
}

TEST(TimeLimit, WorkThatIsDoneWaitsForNothing) {
  const auto started = std::chrono::steady_clock::now();
  { const time_limit limit(cancel_token(), 600); }
  EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(60));
}

}  // namespace
}  // namespace tedit
