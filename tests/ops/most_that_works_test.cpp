// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/most_that_works.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

/// What was asked for is refused at once; each try of the search does as `then` says.
class MostThatWorks : public ::testing::Test {
protected:
  expected<edit_result> ask(const value_trial& then) {
    const value_trial trial = [&](double value, context& ctx) -> expected<edit_result> {
      if (++trials_ == 1)
        return fail(ec::cap_intersects, "the wall is thinner");
      return then(value, ctx);
    };
    return at_most(test::box_mesh({1, 1, 1}, {1, 1, 1}), {"depth", "depth", .3}, trial, ctx_);
  }

  static expected<edit_result> work_until_cancelled(const context& ctx) {
    while (!ctx.run.cancel.cancelled())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return fail(ec::cancelled, "the trial was cancelled");
  }

  context ctx_;
  int trials_ = 0;
};

TEST_F(MostThatWorks, ATrialIsEndedWhenTheTimeOfTheSearchIsOver) {
  ctx_.search_s = .05;

  const auto refused = ask([](double, context& ctx) { return work_until_cancelled(ctx); });

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::cap_intersects);
  EXPECT_EQ(refused.error().remedy, "Take a smaller depth, or select other surfaces");
  EXPECT_FALSE(refused.error().most);
  EXPECT_EQ(trials_, 2);
}

TEST_F(MostThatWorks, ACancelOfTheEditEndsTheSearchAsACancel) {
  ctx_.search_s = 1e9;

  const auto refused = ask([&](double, context& ctx) {
    ctx_.run.cancel.cancel();
    return work_until_cancelled(ctx);
  });

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::cancelled);
  EXPECT_EQ(trials_, 2);
}

TEST_F(MostThatWorks, WhereNothingWorksItIsSaidAfterAllTrials) {
  ctx_.search_s = 1e9;

  const auto refused = ask([](double, context&) -> expected<edit_result> {
    return fail(ec::cap_intersects, "the wall is thinner");
  });

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().remedy, "Select other surfaces: a smaller depth does not work here");
  EXPECT_EQ(trials_, 1 + 8);  // 200, 100, 50, ... 1 mm.
}

}  // namespace
}  // namespace tedit::ops
