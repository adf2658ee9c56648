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

TEST_F(Pattern, CopiesMayBeUnevenlyApart) {
  const auto mesh = with_hole({0.2, 0.3, 0.2});
  const auto motions = uneven_motions({{0.25, 0.6}, {9, 0, 0}, 2, {0, 0.4, 0}});
  ASSERT_TRUE(motions);

  const auto result = repeated(mesh, "bore", *motions);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, -5 * hole_volume(0.2), 1e-8);
  EXPECT_EQ(places(*result->candidate, "bore"),
            (std::vector<std::array<double, 2>>{
              {0.2, 0.3}, {0.2, 0.7}, {0.45, 0.3}, {0.45, 0.7}, {0.8, 0.3}, {0.8, 0.7}}));
}

TEST_F(Pattern, AnglesOfARingAreFromTheOneThatIsThere) {
  const auto motions = angle_motions({1, 0, 0}, {0, 0, 1}, {std::numbers::pi / 2, -0.5});
  ASSERT_TRUE(motions);

  ASSERT_EQ(motions->size(), 2u);
  EXPECT_LT(norm((*motions)[0]({2, 0, 5}) - vec3{1, 1, 5}), 1e-12);
  EXPECT_LT(norm((*motions)[1]({2, 0, 0}) - vec3{1 + std::cos(0.5), -std::sin(0.5), 0}), 1e-12);
}

/// As the host completes them.
parameters pattern_values(const parameters& given) {
  parameters values{{"kind", std::string("rows")},
                    {"count", std::int64_t{2}},
                    {"step", std::string("0, 0, 0")},
                    {"rows", std::int64_t{1}},
                    {"row_step", std::string("0, 0, 0")},
                    {"at", std::string("0, 0, 0")},
                    {"direction", std::string("0, 0, 1")},
                    {"angle", 2 * std::numbers::pi},
                    {"axis", std::string()},
                    {"plane", std::string()},
                    {"distances", std::string()},
                    {"angles", std::string()}};
  for (const auto& [id, value] : given)
    values[id] = value;
  return values;
}

TEST_F(Pattern, AnAxisAPlaneAndListsStandInsteadOfTheOthers) {
  const auto moved = [](const parameters& given, vec3 p) {
    const auto motions = pattern_motions(pattern_values(given));
    EXPECT_TRUE(motions) << render(motions.error());
    std::vector<vec3> places;
    for (const auto& motion : motions.value_or(std::vector<motion>{}))
      places.push_back(motion(p));
    return places;
  };
  const auto text = [](const char* words) { return std::string(words); };

  // Half a turn around x = 1 along y; the direction has any length.
  const auto ring = moved({{"kind", text("ring")}, {"axis", text("1, 0, 0; 0, 5, 0")}}, {});
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_LT(norm(ring[0] - vec3{2, 0, 0}), 1e-12);
  const auto mirror = moved({{"kind", text("mirror")}, {"plane", text("0, 0, 3; 0, 0, -2")}}, {});
  ASSERT_EQ(mirror.size(), 1u);
  EXPECT_LT(norm(mirror[0] - vec3{0, 0, 6}), 1e-12);
  const auto rows = moved({{"distances", text("0.5, -2")}, {"step", text("0, 7, 0")}}, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_LT(norm(rows[0] - vec3{0, 0.5, 0}) + norm(rows[1] - vec3{0, -2, 0}), 1e-12);
  EXPECT_EQ(moved({{"kind", text("ring")}, {"angles", text("1, 2, 3")}}, {}).size(), 3u);
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
  constexpr double whole = 2 * std::numbers::pi;
  for (const auto& angles : {std::vector{0.0}, {whole}, {1.0, 1.0}, {1.0, 1.0 - whole}})
    EXPECT_THAT(angle_motions({}, {0, 0, 1}, angles).error().message, HasSubstr("same place"));
  for (const auto& far : {std::vector{0.1, 0.0}, {0.1, 0.1}, {0.1, 0.1 + 1e-12}})
    EXPECT_THAT(uneven_motions({far, {1, 0, 0}}).error().message, HasSubstr("same place"));
  EXPECT_THAT(uneven_motions({{0.1}, {}}).error().message, HasSubstr("which way"));
  EXPECT_THAT(
    uneven_motions({std::vector<double>(600, 1), {1, 0, 0}, 2, {0, 1, 0}}).error().message,
    HasSubstr("1201 copies"));
}

}  // namespace
}  // namespace tedit::ops
