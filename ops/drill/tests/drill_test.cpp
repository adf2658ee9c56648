// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/drill/drill.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

/// Area of the regular polygon with n corners on the circle.
double polygon_area(double diameter, int n) {
  return 0.5 * n * std::pow(diameter / 2, 2) * std::sin(2 * std::numbers::pi / n);
}

class Drill : public test::tool_edits {
protected:
  expected<edit_result> drilled(const drill_shape& shape, vec3 at, vec3 outward) {
    return drill(plate_, {at, outward, 0.1}, shape, {}, ctx_);
  }

  version_ptr plate_ = test::box_mesh({10, 10, 2}, {1, 1, 0.2});
  const vec3 up_{0, 0, 1};
};

TEST_F(Drill, AHoleThroughAPlateTakesOffItsPrism) {
  const auto result = drilled({.diameter = 0.3}, {0.47, 0.52, 0.2}, up_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -0.2 * polygon_area(0.3, 24), 1e-8);
  EXPECT_NEAR(area_of(*result->candidate, "bore"), 0.2 * 24 * 0.3 * std::sin(std::numbers::pi / 24),
              1e-6);
  EXPECT_EQ(result->candidate->surfaces().size(), 7u);
}

TEST_F(Drill, ItGoesIntoTheMaterialWhicheverWayTheAxisPoints) {
  const auto from_above = drilled({.diameter = 0.3, .depth = 0.1}, {0.5, 0.5, 0.2}, up_);
  const auto pointing_down = drilled({.diameter = 0.3, .depth = 0.1}, {0.5, 0.5, 0.2}, -up_);

  ASSERT_TRUE(from_above && pointing_down);
  EXPECT_NEAR(from_above->volume_change, -0.1 * polygon_area(0.3, 24), 1e-8);
  EXPECT_NEAR(pointing_down->volume_change, from_above->volume_change, 1e-8);
}

TEST_F(Drill, ABlindHoleHasATip) {
  const double tip = 2 * std::atan(1.5);  // A cone two thirds as high as its radius.
  const auto result =
    drilled({.diameter = 0.3, .depth = 0.05, .tip_angle = tip}, {0.5, 0.5, 0.2}, up_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -(0.05 + 0.1 / 3) * polygon_area(0.3, 24), 1e-8);
}

TEST_F(Drill, ACounterboreAndACountersinkWidenItsMouth) {
  const auto bore =
    drilled({.diameter = 0.2, .counterbore_diameter = 0.4, .counterbore_depth = 0.08},
            {0.5, 0.5, 0.2}, up_);
  const auto sink = drilled(
    {.diameter = 0.2, .countersink_diameter = 0.4, .countersink_angle = std::numbers::pi / 2},
    {0.5, 0.5, 0.2}, up_);

  ASSERT_TRUE(bore) << render(bore.error());
  ASSERT_TRUE(sink) << render(sink.error());
  expect_good(plate_, *bore);
  expect_good(plate_, *sink);
  EXPECT_NEAR(bore->volume_change, -0.08 * polygon_area(0.4, 24) - 0.12 * polygon_area(0.2, 24),
              1e-8);
  // A frustum 0.1 high with radii of 0.2 and 0.1, and the bore below.
  const double frustum = 0.1 / 3 * 7 * polygon_area(0.2, 24);
  EXPECT_NEAR(sink->volume_change, -frustum - 0.1 * polygon_area(0.2, 24), 1e-8);
}

TEST_F(Drill, ACounterboreDeeperThanThePartGoesThrough) {
  const auto result = drilled(
    {.diameter = 0.2, .counterbore_diameter = 0.4, .counterbore_depth = 0.9}, {0.5, 0.5, 0.2}, up_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -0.2 * polygon_area(0.4, 24), 1e-8);
}

TEST_F(Drill, ThreadsHaveTheirCores) {
  EXPECT_EQ(thread_core("M6"), 5.0e-3);
  EXPECT_FALSE(thread_core("none"));
  EXPECT_EQ(threads().size(), 14u);
}

TEST_F(Drill, WhatIsNoHoleIsToldBeforeAnythingIsCut) {
  const auto both = drilled({.diameter = 0.2,
                             .counterbore_diameter = 0.3,
                             .counterbore_depth = 0.01,
                             .countersink_diameter = 0.3,
                             .countersink_angle = 1.5},
                            {0.5, 0.5, 0.2}, up_);
  const auto narrow = drilled({.diameter = 0.2, .counterbore_diameter = 0.1}, {0.5, 0.5, 0.2}, up_);

  ASSERT_FALSE(both);
  EXPECT_THAT(both.error().message, HasSubstr("not both"));
  ASSERT_FALSE(narrow);
  EXPECT_EQ(narrow.error().code, ec::invalid_parameter);
}

TEST_F(Drill, BesideThePartThereIsNothingToDrill) {
  const auto result = drilled({.diameter = 0.2}, {3, 3, 0.2}, up_);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::empty_selection);
  EXPECT_FALSE(result.error().remedy.empty());
}

class DrillPlaces : public Drill {
protected:
  /// Into the top of the plate, surface 6; through it where no depth is given.
  expected<edit_result> holes(const std::string& places, const std::string& at = {},
                              double depth = 0, double diameter = 0.1) {
    const parameters values{{"places", places},
                            {"at", at},
                            {"direction", std::string()},
                            {"diameter", diameter},
                            {"depth", depth},
                            {"thread", std::string("none")},
                            {"tip_angle", 0.0},
                            {"counterbore_diameter", 0.0},
                            {"counterbore_depth", 0.0},
                            {"countersink_diameter", 0.0},
                            {"countersink_angle", 1.5}};
    return drill_holes(plate_, {{6}}, values, ctx_);
  }
};

/// Four bores that can be told from each other, each with its own wall.
TEST_F(DrillPlaces, AllHolesAreOneEditAndHaveTheirOwnNames) {
  const auto result = holes("0.2,0.2,0.2; 0.8,0.2,0.2; 0.8,0.8,0.2", "0.2,0.8,0.2");

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -4 * 0.2 * polygon_area(0.1, 24), 1e-12);
  for (const auto* name : {"bore", "bore 2", "bore 3", "bore 4"})
    EXPECT_NEAR(area_of(*result->candidate, name), 0.2 * 24 * 0.1 * std::sin(std::numbers::pi / 24),
                1e-12)
      << name;
  EXPECT_EQ(result->candidate->surfaces().size(), 10u);
}

/// Two that overlap, and a third apart: one after the other.
TEST_F(DrillPlaces, HolesMayCutEachOther) {
  const auto result = holes("0.3,0.3,0.2; 0.38,0.3,0.2; 0.7,0.7,0.2");

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  const double each = 0.2 * polygon_area(0.1, 24);
  EXPECT_LT(-result->volume_change, 3 * each);
  // What two circles have in common, 0.08 apart: between a circle and its 24 edges.
  const double lens =
    2 * 0.05 * 0.05 * std::acos(0.8) - 0.04 * std::sqrt(4 * 0.05 * 0.05 - 0.08 * 0.08);
  EXPECT_NEAR(-result->volume_change, 3 * each - 0.2 * lens, 0.2 * 0.1 * lens);
}

TEST_F(DrillPlaces, WhereOneCannotBeNoneIsMadeAndItIsNamed) {
  const auto beside = holes("0.2,0.2,0.2; 0.8,0.2,0.2; 3,0.8,0.2");
  const auto within = holes("0.2,0.2,0.2; 0.201,0.2,0.2; 0.8,0.8,0.2", {}, 0.1);
  const auto twice = holes("0.2,0.2,0.2; 0.8,0.2,0.2", "0.8,0.2,0.2");

  ASSERT_FALSE(beside);
  EXPECT_EQ(beside.error().code, ec::empty_selection);
  EXPECT_THAT(beside.error().message, HasSubstr("place 3 of 3 (3000, 800, 200 mm): "));
  EXPECT_FALSE(beside.error().remedy.empty());
  ASSERT_TRUE(within) << render(within.error());  // A hair to the right is still a hole.
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, HasSubstr("places 1 and 3 are the same"));
}

TEST_F(DrillPlaces, AShapeThatIsNoneIsToldWithTheFirstPlace) {
  const auto fine = holes("0.2,0.2,0.2; 0.8,0.2,0.2", {}, 0, 1e-5);

  ASSERT_FALSE(fine);
  EXPECT_THAT(fine.error().message, HasSubstr("place 1 of 2 (200, 200, 200 mm): "));
}

/// A block whose top is a dome of free form, of facets that are up to 3 mm off it.
class DrillInADome : public Drill {
protected:
  static double height(double x, double y) {
    return 0.4 + 0.3 * std::sin(2.5 * x + 0.2) * std::sin(2 * y + 0.4);
  }

  /// m: how far vertices of the top that are not the block's are off the dome, at most.
  [[nodiscard]] double furthest_off(const mesh_version& mesh) const {
    double furthest = 0;
    for (const auto f : facets_of(mesh, std::array<surface_id, 1>{6}))
      for (const auto v : mesh.facet(f).v)
        if (const vec3 p = mesh.position(v); v >= dome_->vertex_slots())
          furthest = std::max(furthest, std::abs(p.z - height(p.x, p.y)));
    return furthest;
  }

  version_ptr dome_ = test::box_mesh({10, 10, 3}, {1, 1, 1}, [](vec3 p) {
    return vec3{p.x, p.y, p.z * height(p.x, p.y)};
  });
};

/// On the facets the rim would be off it by up to l^2 / 8 R: edges of 0.14 bend by 1 / R = 1.9.
TEST_F(DrillInADome, TheRimLiesOnTheWallThatTheFacetsStandFor) {
  for (const vec3 at : {vec3{0.47, 0.52, 0}, {0.31, 0.64, 0}, {0.66, 0.37, 0}}) {
    const auto result =
      drill(dome_, {{at.x, at.y, height(at.x, at.y)}, up_, 0.1}, {.diameter = 0.25}, {}, ctx_);

    ASSERT_TRUE(result) << render(result.error());
    expect_good(dome_, *result);
    EXPECT_LT(furthest_off(*result->candidate), 1e-4);
  }
}

}  // namespace
}  // namespace tedit::ops
