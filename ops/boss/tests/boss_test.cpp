// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boss/boss.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

class Boss : public test::tool_edits {
protected:
  expected<edit_result> add(parameters changed) {
    parameters values{{"profile", std::string("circle")},
                      {"size", 0.3},
                      {"width", 0.0},
                      {"corners", std::int64_t{6}},
                      {"along", std::string()},
                      {"file", std::string()},
                      {"height", 0.25},
                      {"at", std::string()},
                      {"direction", std::string()}};
    for (auto& [id, value] : changed)
      values[id] = value;
    return add_boss(plate_, selection{{6}}, values, ctx_);
  }

  version_ptr plate_ = test::box_mesh({10, 10, 2}, {1, 1, 0.2});
};

TEST_F(Boss, StandsOnItsWall) {
  const auto result = add({});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  const double area = 0.5 * 24 * 0.15 * 0.15 * std::sin(2 * std::numbers::pi / 24);
  EXPECT_NEAR(result->volume_change, 0.25 * area, 1e-12);
  EXPECT_NEAR(area_of(*result->candidate, "boss top"), area, 1e-12);
  EXPECT_EQ(area_of(*result->candidate, "boss bottom"), 0);
}

TEST_F(Boss, AHexagonHasSixSides) {
  const auto result = add({{"profile", std::string("polygon")}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_EQ(result->candidate->surfaces().size(), 6u + 6 + 1);
}

TEST_F(Boss, OverAnEdgeItHangsOut) {
  const auto result = add({{"profile", std::string("rectangle")},
                           {"size", 0.4},
                           {"width", 0.2},
                           {"at", std::string("1, 0.5, 0.2")}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, 0.4 * 0.2 * 0.25, 1e-12);
}

TEST_F(Boss, CutOffAgainThePartIsWhatItWas) {
  const auto result = add({});
  ASSERT_TRUE(result) << render(result.error());

  const auto tool =
    half_space(extent_of(*result->candidate), {0, 0, 0.2}, {0, 0, -1}, 0.1, "cut", *host_);
  ASSERT_TRUE(tool);
  const auto back = host_->boolean(result->candidate, *tool, {}, {});

  ASSERT_TRUE(back) << render(back.error());
  EXPECT_NEAR(total_volume(*back->candidate), total_volume(*plate_), 1e-12);
}

}  // namespace
}  // namespace tedit::ops
