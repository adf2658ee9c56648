// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/plane_cut/plane_cut.hpp"

#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

class PlaneCut : public test::tool_edits {
protected:
  version_ptr block_ = test::box_mesh({6, 6, 6}, {1, 1, 1});
};

TEST_F(PlaneCut, KeepsTheSideThatIsAskedFor) {
  const auto below = plane_cut(block_, {0, 0, 0.3}, {0, 0, 1}, true, {}, ctx_);
  const auto above = plane_cut(block_, {0, 0, 0.3}, {0, 0, 1}, false, {}, ctx_);

  ASSERT_TRUE(below) << render(below.error());
  ASSERT_TRUE(above) << render(above.error());
  expect_good(block_, *below);
  expect_good(block_, *above);
  EXPECT_NEAR(total_volume(*below->candidate), 0.3, 1e-12);
  EXPECT_NEAR(total_volume(*above->candidate), 0.7, 1e-12);
  EXPECT_NEAR(area_of(*below->candidate, "cut"), 1, 1e-12);
}

TEST_F(PlaneCut, AlongACornersDiagonal) {
  const auto result = plane_cut(block_, {0.5, 0.5, 0.5}, {1, 1, 1}, true, {}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(total_volume(*result->candidate), 0.5, 1e-12);
}

TEST_F(PlaneCut, AlongGridPlanesOfTheMesh) {
  const auto result = plane_cut(block_, {0.5, 0, 0}, {1, 0, 0}, true, {}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(total_volume(*result->candidate), 0.5, 1e-12);
}

TEST_F(PlaneCut, BesideThePartChangesNothing) {
  for (const bool below : {true, false}) {
    const auto result = plane_cut(block_, {0, 0, 2}, {0, 0, 1}, below, {}, ctx_);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ec::empty_selection) << render(result.error());
  }
  const auto flush = plane_cut(block_, {0, 0, 1}, {0, 0, 1}, true, {}, ctx_);
  ASSERT_FALSE(flush);
  EXPECT_EQ(flush.error().code, ec::empty_selection) << render(flush.error());
}

}  // namespace
}  // namespace tedit::ops
