// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pocket/pocket.hpp"

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

}  // namespace
}  // namespace tedit::ops
