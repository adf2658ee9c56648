// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pocket/pocket.hpp"

#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

class Pocket : public test::tool_edits {
protected:
  expected<edit_result> cut(parameters changed, const std::vector<surface_id>& surfaces = {6}) {
    parameters values{{"profile", std::string("rectangle")},
                      {"size", 0.4},
                      {"width", 0.3},
                      {"corners", std::int64_t{6}},
                      {"along", std::string()},
                      {"file", std::string()},
                      {"height", 0.1},
                      {"at", std::string()},
                      {"direction", std::string()}};
    for (auto& [id, value] : changed)
      values[id] = value;
    return cut_pocket(plate_, selection{surfaces}, values, ctx_);
  }

  version_ptr plate_ = test::box_mesh({10, 10, 2}, {1, 1, 0.2});
};

TEST_F(Pocket, TakesOffItsBoxInTheMiddleOfTheWall) {
  const auto result = cut({});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -0.4 * 0.3 * 0.1, 1e-12);
  EXPECT_NEAR(area_of(*result->candidate, "pocket bottom"), 0.4 * 0.3, 1e-12);
  EXPECT_EQ(result->figures.front().id, "deviation_mm");
}

TEST_F(Pocket, OfNoDepthItGoesThrough) {
  const auto result = cut({{"height", 0.0}, {"at", std::string("0.5, 0.5, 0.2")}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -0.4 * 0.3 * 0.2, 1e-12);
}

TEST_F(Pocket, TurnsWithTheDirectionOfItsLength) {
  const auto result = cut({{"along", std::string("0, 1, 0")}, {"size", 0.8}, {"width", 0.1}});

  ASSERT_TRUE(result) << render(result.error());
  double low = 1;
  for (const auto& row : result->candidate->surfaces())
    if (row.name == "pocket bottom")
      for (const auto f : facets_of(*result->candidate, std::array{row.id}))
        for (const auto v : result->candidate->facet(f).v)
          low = std::min(low, result->candidate->position(v).y);
  EXPECT_NEAR(low, 0.1, 1e-12);
}

TEST_F(Pocket, ReachesOverAnEdge) {
  const auto result = cut({{"at", std::string("1, 0.5, 0.2")}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -0.2 * 0.3 * 0.1, 1e-12);
}

/// The corners (0.2, 0.2), (0.8, 0.2), (0.2, 0.8): half of 0.6 x 0.6.
TEST_F(Pocket, OfPointsTakesOffWhatLiesBetweenThem) {
  for (const auto* points :
       {"0.2,0.2,0.2; 0.8,0.2,0.2; 0.2,0.8,0.2", "0.2,0.8,0.2; 0.8,0.2,0.2; 0.2,0.2,0.2",
        "0.2,0.2,0.9; 0.8,0.2,-3; 0.2,0.8,0.2; 0.2,0.2,0.9"})
    for (const auto& wall : {std::vector<surface_id>{6}, std::vector<surface_id>{}}) {
      if (wall.empty() && std::string(points).ends_with("0.9"))
        continue;  // The middle of such points is no place on the wall.
      const auto result =
        cut({{"profile", std::string("points")}, {"points", std::string(points)}}, wall);

      ASSERT_TRUE(result) << render(result.error());
      expect_good(plate_, *result);
      EXPECT_NEAR(result->volume_change, -0.18 * 0.1, 1e-12) << points;
      EXPECT_NEAR(area_of(*result->candidate, "pocket bottom"), 0.18, 1e-12);
      EXPECT_NEAR(area_of(*result->candidate, "pocket side 1") +
                    area_of(*result->candidate, "pocket side 2") +
                    area_of(*result->candidate, "pocket side 3"),
                  0.1 * (1.2 + std::sqrt(0.72)), 1e-12);
    }
}

/// An L of 0.6 x 0.6 without a quarter of 0.3 x 0.3, turned with nothing: `along` turns no points.
TEST_F(Pocket, OfPointsMayBeConcaveAndIsNotTurned) {
  const auto result = cut({{"profile", std::string("points")},
                           {"along", std::string("1, 1, 0")},
                           {"points", std::string("0.2,0.2,0.2; 0.8,0.2,0.2; 0.8,0.5,0.2; "
                                                  "0.5,0.5,0.2; 0.5,0.8,0.2; 0.2,0.8,0.2")}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -0.27 * 0.1, 1e-12);
}

TEST_F(Pocket, PointsThatAreNoOutlineAreRefusedByName) {
  const auto refusal = [&](const std::string& profile, const std::string& points) {
    const auto result = cut({{"profile", profile}, {"points", points}});
    EXPECT_FALSE(result) << points;
    return result ? "" : render(result.error());
  };
  using ::testing::HasSubstr;

  EXPECT_THAT(refusal("points", "0.2,0.2,0.2; 0.8,0.8,0.2; 0.8,0.2,0.2; 0.2,0.8,0.2"),
              HasSubstr("crosses itself between its points 1 and 3"));
  EXPECT_THAT(refusal("points", "0.2,0.2,0.2; 0.5,0.5,0.2; 0.8,0.8,0.2"),
              HasSubstr("enclose nothing"));
  EXPECT_THAT(refusal("points", "0.2,0.2,0.2; 0.2,0.2,0.5; 0.2,0.2,0.8"),
              HasSubstr("enclose nothing"));
  EXPECT_THAT(refusal("points", ""), HasSubstr("none were given"));
  EXPECT_THAT(refusal("circle", "0.2,0.2,0.2; 0.5,0.5,0.2; 0.8,0.8,0.2"),
              HasSubstr("the profile is another one"));
  EXPECT_THAT(refusal("points", "0.2,0.2,0.2; 0.2001,0.2,0.2; 0.8,0.2,0.2; 0.2,0.8,0.2"),
              HasSubstr("too small for the mesh"));
}

TEST_F(Pocket, NeedsAPlaceOrAWall) {
  const auto result = cut({}, {});

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::empty_selection);
}

TEST_F(Pocket, ASlotIsLongerThanWide) {
  const auto result = cut({{"profile", std::string("slot")}, {"width", 0.5}});

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_parameter);
}

TEST_F(Pocket, SeveralAreMadeAtOnceOrNone) {
  const parameters small{{"size", 0.1}, {"width", 0.1}, {"height", 0.1}};
  auto given = small;
  given["places"] = std::string("0.2, 0.2, 0.2; 0.8, 0.8, 0.2; 0.2, 0.8, 0.2");
  const auto result = cut(given);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -3 * 0.1 * 0.1 * 0.1, 1e-12);
  EXPECT_NEAR(area_of(*result->candidate, "pocket bottom 3"), 0.1 * 0.1, 1e-12);

  given["places"] = std::string("0.2, 0.2, 0.2; 0.8, 5, 0.2");
  const auto beside = cut(given);
  ASSERT_FALSE(beside);
  EXPECT_THAT(beside.error().message, ::testing::HasSubstr("place 2 of 2 (800, 5000, 200 mm): "));
  given["profile"] = std::string("points");
  given["points"] = std::string("0.2, 0.2, 0.2; 0.4, 0.2, 0.2; 0.4, 0.4, 0.2");
  EXPECT_THAT(cut(given).error().message, ::testing::HasSubstr("is in one place"));
}

}  // namespace
}  // namespace tedit::ops
