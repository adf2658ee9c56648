// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pattern/pattern.hpp"

#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/support/features_on_plate.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class Pattern : public test::features_on_plate {
protected:
  expected<edit_result> repeated(const version_ptr& mesh, const std::string& name,
                                 const std::vector<motion>& motions) {
    return repeat_features(mesh, {surface_named(*mesh, name)}, motions, ctx_);
  }

  /// Of all surfaces with this name, by x and then y, to the micrometre.
  static std::vector<std::array<double, 2>> places(const mesh_version& mesh,
                                                   const std::string& name) {
    std::vector<std::array<double, 2>> result;
    for (const auto& row : mesh.surfaces())
      if (row.name == name) {
        const auto m = middle_of_surface(mesh, row.id);
        result.push_back({std::round(1e6 * m.x) / 1e6, std::round(1e6 * m.y) / 1e6});
      }
    std::ranges::sort(result);
    return result;
  }
};

TEST_F(Pattern, RowsOfHolesAreWhereTheyShouldBe) {
  const auto mesh = with_hole({0.2, 0.3, 0.2});
  const auto motions = grid_motions({3, {0.3, 0, 0}, 2, {0, 0.4, 0}});
  ASSERT_TRUE(motions);
  EXPECT_EQ(motions->size(), 5u);

  const auto result = repeated(mesh, "bore", *motions);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, -5 * hole_volume(0.2), 1e-8);
  EXPECT_EQ(places(*result->candidate, "bore"),
            (std::vector<std::array<double, 2>>{
              {0.2, 0.3}, {0.2, 0.7}, {0.5, 0.3}, {0.5, 0.7}, {0.8, 0.3}, {0.8, 0.7}}));
}

TEST_F(Pattern, ARingOfFourIsAQuarterTurnApart) {
  const auto mesh = with_hole({0.8, 0.5, 0.2});
  const auto motions = ring_motions({0.5, 0.5, 0}, {0, 0, 1}, 4, 2 * std::numbers::pi);
  ASSERT_TRUE(motions);

  const auto result = repeated(mesh, "bore", *motions);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_EQ(places(*result->candidate, "bore"),
            (std::vector<std::array<double, 2>>{{0.2, 0.5}, {0.5, 0.2}, {0.5, 0.8}, {0.8, 0.5}}));
}

TEST_F(Pattern, PartOfATurnIsSharedFromTheFirstToTheLast) {
  const auto motions = ring_motions({}, {0, 0, 1}, 3, std::numbers::pi);
  ASSERT_TRUE(motions);
  const vec3 last = motions->back()({1, 0, 0.5});
  const vec3 middle = motions->front()({1, 0, 0.5});

  EXPECT_LT(norm(last - vec3{-1, 0, 0.5}), 1e-12);
  EXPECT_LT(norm(middle - vec3{0, 1, 0.5}), 1e-12);
}

TEST_F(Pattern, AMirroredBossStandsOnTheOtherSide) {
  const auto mesh = with_boss(plate_, {0.1, 0.3, 0.2}, {0.3, 0.6, 0.3});

  const auto result = repeated(mesh, "boss top", {mirror_in({0.5, 0.5, 0}, {1, 0, 0})});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, 0.2 * 0.3 * 0.1, 1e-12);
  EXPECT_EQ(places(*result->candidate, "boss top"),
            (std::vector<std::array<double, 2>>{{0.2, 0.45}, {0.8, 0.45}}));
}

TEST_F(Pattern, ABossThatIsMirroredToTheOtherSideLooksDown) {
  const auto mesh = with_boss(plate_, {0.1, 0.3, 0.2}, {0.3, 0.6, 0.3});

  const auto result = repeated(mesh, "boss top", {mirror_in({0, 0, 0.1}, {0, 0, 1})});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, 0.2 * 0.3 * 0.1, 1e-12);
}

TEST_F(Pattern, TheCopyThatCannotBeIsNamed) {
  const auto mesh = with_hole({0.3, 0.5, 0.2});
  const auto motions = grid_motions({4, {0.35, 0, 0}});
  ASSERT_TRUE(motions);

  const auto result = repeated(mesh, "bore", *motions);

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("copy 3 of 3"));
}

TEST_F(Pattern, NumbersThatMeanNothingAreRefused) {
  EXPECT_THAT(grid_motions({2, {}}).error().message, HasSubstr("same place"));
  EXPECT_THAT(grid_motions({1, {1, 0, 0}}).error().message, HasSubstr("pattern of one"));
  EXPECT_THAT(grid_motions({100, {1, 0, 0}, 100, {0, 1, 0}}).error().message,
              HasSubstr("9999 copies"));
  EXPECT_THAT(ring_motions({}, {0, 0, 1}, 3, 0).error().message, HasSubstr("same place"));
}

}  // namespace
}  // namespace tedit::ops
