// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/sweep/sweep_along.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class SweepAlong : public test::tool_edits {
protected:
  expected<edit_result> sweep(const parameters& changed,
                              const std::vector<surface_id>& walls = {}) {
    parameters values{{"path", std::string("0.2, 0.2, 0.5; 0.8, 0.2, 0.5; 0.8, 0.8, 0.5")},
                      {"profile", std::string("rectangle")},
                      {"size", 0.1},
                      {"height", 0.0},
                      {"mode", std::string("cut")}};
    for (const auto& [id, value] : changed)
      values[id] = value;
    return sweep_along(block_, selection{walls}, values, ctx_);
  }

  version_ptr block_ = test::box_mesh({8, 8, 4}, {1, 1, 0.5});
};

/// 1.2 m long; half of the profile of 0.1 x 0.1 lies in the block, half over it.
TEST_F(SweepAlong, AGrooveAndABeadAreHalfOfTheProfile) {
  for (const bool add : {false, true}) {
    const auto result = sweep({{"mode", std::string(add ? "add" : "cut")}});

    ASSERT_TRUE(result) << render(result.error());
    expect_good(block_, *result);
    EXPECT_NEAR(result->volume_change, (add ? 1 : -1) * 1.2 * 0.1 * 0.05, 1e-12);
    EXPECT_NEAR(area_of(*result->candidate, add ? "bead start" : "groove start"), 0.005, 1e-12);
  }
}

TEST_F(SweepAlong, ItsHeightStandsOnTheWall) {
  const auto on_top = sweep({{"height", 0.2}}, {6});

  ASSERT_TRUE(on_top) << render(on_top.error());
  expect_good(block_, *on_top);
  EXPECT_NEAR(on_top->volume_change, -1.2 * 0.1 * 0.1, 1e-12);
}

/// A channel with both ends in the open, through the block along x: a prism of 24 sides.
TEST_F(SweepAlong, ARoundChannelGoesThrough) {
  const auto result = sweep({{"path", std::string("-0.1, 0.5, 0.25; 1.1, 0.5, 0.25")},
                             {"profile", std::string("circle")},
                             {"size", 0.2}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  const double disc = 0.5 * 24 * 0.01 * std::sin(2 * std::numbers::pi / 24);
  EXPECT_NEAR(result->volume_change, -disc, 1e-9);
}

/// A seat for a seal around the top: a closed square of 0.6 m.
TEST_F(SweepAlong, AClosedPathGoesAllRound) {
  const auto result = sweep(
    {{"path", std::string("0.2,0.2,0.5; 0.8,0.2,0.5; 0.8,0.8,0.5; 0.2,0.8,0.5; 0.2,0.2,0.5")}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(result->volume_change, -(0.7 * 0.7 - 0.5 * 0.5) * 0.05, 1e-12);
}

/// A profile of 40 m takes all of the block between its ends, and no longer to do so.
TEST_F(SweepAlong, AProfileFarLargerThanThePartIsAnsweredAtOnce) {
  const auto result = sweep({{"size", 40.0},
                             {"profile", std::string("circle")},
                             {"path", std::string("-0.1, 0.2, 0.5; 0.8, 0.2, 0.5")}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(result->volume_change, -0.8 * 0.5, 1e-9);
}

TEST_F(SweepAlong, WhatCannotBeIsRefusedAndSaysWhy) {
  const auto refusal = [&](const parameters& changed) {
    const auto result = sweep(changed);
    EXPECT_FALSE(result);
    return result ? "" : render(result.error());
  };

  EXPECT_THAT(refusal({{"path", std::string()}}), HasSubstr("no path was given"));
  EXPECT_THAT(refusal({{"path", std::string("5, 5, 5; 6, 5, 5")}}), HasSubstr("part"));
  EXPECT_THAT(refusal({{"path", std::string("0.2,0.5,0.25; 0.8,0.5,0.25")}}),
              HasSubstr("closed void"));
  EXPECT_THAT(refusal({{"path", std::string("0.2,0.2,0.5; 0.8,0.2,0.5; 0.3,0.21,0.5")}}),
              HasSubstr("point 2 the path turns back"));
  EXPECT_THAT(refusal({{"size", 1e-5}}), HasSubstr("too small for the mesh"));
}

}  // namespace
}  // namespace tedit::ops
