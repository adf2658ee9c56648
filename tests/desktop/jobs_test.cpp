// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/jobs.hpp"

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

TEST(Remaining, FollowsFromWhatWasDoneSinceTheFractionWasSeen) {
  EXPECT_EQ(remaining_ms(2000, 0, 0.5), 2000);
  EXPECT_EQ(remaining_ms(3000, 0.2, 0.5), 5000);
}

TEST(Remaining, IsNotSaidBeforeItIsKnown) {
  EXPECT_FALSE(remaining_ms(900, 0, 0.5));      // Too soon.
  EXPECT_FALSE(remaining_ms(60'000, 0, 0.04));  // It has hardly moved.
  EXPECT_FALSE(remaining_ms(5000, 0, 1));
}

TEST(Roughly, IsNoFinerThanItIsKnown) {
  EXPECT_EQ(roughly(std::nullopt), QString());
  EXPECT_EQ(roughly(2000), "nearly done");
  EXPECT_EQ(roughly(8300), "about 10 s left");
  EXPECT_EQ(roughly(44'000), "about 45 s left");
  EXPECT_EQ(roughly(100'000), "about 2 min left");
}

TEST(Jobs, AreListedWhileTheyRunAndCancelledOnce) {
  jobs all;
  int told = 0;
  int cancelled = 0;
  QObject::connect(&all, &jobs::changed, [&] { ++told; });

  const int edit = all.begin("Fill hole", [&] { ++cancelled; });
  const int solve = all.begin("Solve", nullptr);
  all.progress(edit, 0.25, "removing");
  all.cancel(edit);
  all.cancel(edit);
  all.cancel(solve);  // It cannot be.

  ASSERT_EQ(all.all().size(), 2U);
  EXPECT_EQ(all.all()[0].fraction, 0.25);
  EXPECT_EQ(all.all()[0].stage, "cancelling");
  EXPECT_FALSE(all.all()[0].cancel);
  EXPECT_EQ(cancelled, 1);
  all.end(edit);
  all.end(edit);
  EXPECT_EQ(all.all().size(), 1U);
  EXPECT_EQ(told, 5);
}

}  // namespace
}  // namespace tedit::desktop
