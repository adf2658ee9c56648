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
  const auto below = plane_cut(block_, {0, 0, 0.3}, {0, 0, 1}, kept_side::below, {}, ctx_);
  const auto above = plane_cut(block_, {0, 0, 0.3}, {0, 0, 1}, kept_side::above, {}, ctx_);

  ASSERT_TRUE(below) << render(below.error());
  ASSERT_TRUE(above) << render(above.error());
  expect_good(block_, *below);
  expect_good(block_, *above);
  EXPECT_NEAR(total_volume(*below->candidate), 0.3, 1e-12);
  EXPECT_NEAR(total_volume(*above->candidate), 0.7, 1e-12);
  EXPECT_NEAR(area_of(*below->candidate, "cut"), 1, 1e-12);
}

TEST_F(PlaneCut, InTwoEachSideHasACutOfItsOwnAndTheOldSurfacesAreOnBoth) {
  const auto result = plane_cut(block_, {0, 0, 0.3}, {0, 0, 1}, kept_side::both, {}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  const auto& after = *result->candidate;
  EXPECT_NEAR(result->volume_change, 0, 1e-12);
  EXPECT_NEAR(total_volume(after), 1, 1e-12);
  EXPECT_EQ(result->bodies_added, 1u);
  EXPECT_NEAR(area_of(after, "cut below"), 1, 1e-12);
  EXPECT_NEAR(area_of(after, "cut above"), 1, 1e-12);
  EXPECT_EQ(after.surfaces().size(), 6u + 2);
  // Side walls are on both bodies: 1 x 1 m each.
  for (const surface_id side : {1, 2, 3, 4}) {
    double area = 0;
    for (const auto f : facets_of(after, std::array{side}))
      area += norm(area_vector(after, after.facet(f)));
    EXPECT_NEAR(area, 1, 1e-12) << side;
  }
}

TEST_F(PlaneCut, APlaneStandsInsteadOfPlaceAndNormal) {
  parameters values{
    {"at", std::string()}, {"normal", std::string()}, {"plane", std::string("0, 0, 0.3; 0, 0, 2")}};
  const auto where = placement_of(*block_, {}, values, "normal", 0);
  values["at"] = std::string("0, 0, 0");
  const auto both = placement_of(*block_, {}, values, "normal", 0);

  ASSERT_TRUE(where) << render(where.error());
  EXPECT_EQ(where->at, (vec3{0, 0, 0.3}));
  EXPECT_EQ(where->outward, (vec3{0, 0, 1}));
  ASSERT_FALSE(both);
  EXPECT_EQ(both.error().code, ec::invalid_parameter);
}

TEST_F(PlaneCut, AlongACornersDiagonal) {
  const auto result = plane_cut(block_, {0.5, 0.5, 0.5}, {1, 1, 1}, kept_side::below, {}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(total_volume(*result->candidate), 0.5, 1e-12);
}

TEST_F(PlaneCut, AlongGridPlanesOfTheMesh) {
  const auto result = plane_cut(block_, {0.5, 0, 0}, {1, 0, 0}, kept_side::below, {}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(total_volume(*result->candidate), 0.5, 1e-12);
}

TEST_F(PlaneCut, BesideThePartChangesNothing) {
  for (const auto side : {kept_side::below, kept_side::above, kept_side::both}) {
    const auto result = plane_cut(block_, {0, 0, 2}, {0, 0, 1}, side, {}, ctx_);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ec::empty_selection) << render(result.error());
  }
  const auto flush = plane_cut(block_, {0, 0, 1}, {0, 0, 1}, kept_side::below, {}, ctx_);
  ASSERT_FALSE(flush);
  EXPECT_EQ(flush.error().code, ec::empty_selection) << render(flush.error());
}

}  // namespace
}  // namespace tedit::ops
