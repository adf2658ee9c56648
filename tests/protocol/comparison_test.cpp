// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/comparison.hpp"

#include <gtest/gtest.h>

#include "tedit/v1/comparison.pb.h"

namespace tedit::protocol {
namespace {

/// Each number another one: what is put into the wrong place shows.
version_comparison full_comparison() {
  version_comparison all{std::string(32, 'a'), std::string(32, 'b')};
  all.before = {10, 11, 12.5};
  all.after = {20, 21, 22.5};
  all.tets_in_common = 9;
  all.vertices_in_common = 8;
  all.surfaces = {{-3, "bore", presence::only_before, true, 7, 0.5, 0},
                  {4, "cap", presence::only_after, true, std::nullopt, 0, 0.25},
                  {7, "wall", presence::both, false, std::nullopt, 1.5, 1.75}};
  all.deviation = {0.125, {1, 2, 3}, presence::only_before};
  all.load_cases = {{"braking", presence::both, 1.25, 1.5, {"loads[0]: none -> force on 3"}},
                    {"lifting", presence::only_after, std::nullopt, 2.5, {}},
                    {"old", presence::only_before, 3.5, std::nullopt, {}}};
  all.fields = {{"braking", 30, 31, 32, {1e6, 3e6, {4, 5, 6}}, {5e6, 2e6, {7, 8, 9}}, 6e6, 7e6}};
  all.fields.front().min_safety_before = 2.25;
  all.fields.front().preview = true;
  all.not_compared = {{"lifting", "why not", "what to do"}, {"old", "another", "reason"}};
  return all;
}

version_comparison sent(const version_comparison& all) {
  v1::VersionsCompared message;
  to_message(all, &message);
  v1::VersionsCompared arrived;
  EXPECT_TRUE(arrived.ParseFromString(message.SerializeAsString()));
  return from_message(arrived);
}

TEST(ComparisonMessage, AllOfItSurvivesTheWire) {
  EXPECT_EQ(sent(full_comparison()), full_comparison());
  EXPECT_EQ(sent({}), version_comparison{});
}

TEST(ComparisonMessage, FieldsThatHaveNoVertexInCommonHaveNeitherRiseNorFall) {
  auto all = full_comparison();
  all.fields.front().same = all.fields.front().interpolated = 0;
  v1::VersionsCompared message;
  to_message(all, &message);

  EXPECT_FALSE(message.fields(0).has_rise() || message.fields(0).has_fall());
  EXPECT_EQ(from_message(message).fields.front().rise, value_change{});
  EXPECT_EQ(message.fields(0).max_von_mises_after_pa(), 7e6);
}

TEST(ComparisonMessage, WhatIsNotKnownIsAbsentAndNotZero) {
  v1::VersionsCompared message;
  to_message(full_comparison(), &message);

  EXPECT_FALSE(message.load_cases(1).has_mass_before_kg());
  EXPECT_FALSE(message.fields(0).has_min_safety_factor_after());
  EXPECT_FALSE(message.surfaces(2).has_kin());
  EXPECT_EQ(message.surfaces(0).where(), v1::VersionsCompared::ONLY_BEFORE);
  EXPECT_EQ(message.surfaces(2).where(), v1::VersionsCompared::BOTH);
}

}  // namespace
}  // namespace tedit::protocol
