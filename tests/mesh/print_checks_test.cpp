// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/print/print_checks.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/blocks.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using ::testing::ElementsAre;

constexpr double mm = 1e-3;
constexpr double mm2 = 1e-6;

/// 10 x 20 x 30 mm: a wall of 1 mm on x = 0 and one of 8 mm, between them a slot of 1 mm that
/// leaves 2 mm at the bottom.
version_ptr slotted_box() {
  return test::blocks(
    {11, 2, 15}, [](int x, int, int z) { return x != 1 || z == 0; },
    [](vec3 p) {
      const double x = p.x <= 2 ? p.x : 2 + (p.x - 2) * 8 / 9;
      return vec3{x * mm, 10 * p.y * mm, 2 * p.z * mm};
    });
}

TEST(PrintChecks, FindTheWallOfOneMillimetreFromBothSides) {
  const auto mesh = slotted_box();

  const auto report = check_print(*mesh, {.thinner_than = 1.5 * mm});

  ASSERT_TRUE(report.has_value());
  EXPECT_TRUE(report->watertight());
  EXPECT_EQ(report->bodies, 1U);
  EXPECT_NEAR(report->volume, (10 * 20 * 30 - 1 * 20 * 28) * 1e-9, 1e-18);
  // 20 x 28 mm on either side, not the 2 mm beside the slot's bottom.
  EXPECT_NEAR(report->thin_area, 2 * 20 * 28 * mm2, 1e-15);
  ASSERT_EQ(report->thin.size(), 1U);
  EXPECT_NEAR(report->thin[0].worst, 1 * mm, 1e-12);
  EXPECT_THAT(report->thin[0].surfaces, ElementsAre(1, 7));
  EXPECT_NEAR(report->extent.high.z, 30 * mm, 1e-12);
}

TEST(PrintChecks, AWallOfJustTheThicknessIsNotTooThin) {
  const auto mesh = slotted_box();

  EXPECT_TRUE(check_print(*mesh, {.thinner_than = 1 * mm})->thin.empty());
  // The bottom of 2 mm, 1 mm wide, is found from both sides when it is too thin.
  const auto report = check_print(*mesh, {.thinner_than = 2.1 * mm});
  EXPECT_NEAR(report->thin_area, (2 * 20 * 28 + 2 * 20 * 1) * mm2, 1e-15);
}

TEST(PrintChecks, WhatLiesOnThePlateDoesNotOverhang) {
  const auto mesh = slotted_box();

  const auto upright = check_print(*mesh, {});
  const auto turned = check_print(*mesh, {.up = {-2, 0, 0}});

  EXPECT_TRUE(upright->overhangs.empty());
  EXPECT_NEAR(upright->plate_area, 10 * 20 * mm2, 1e-15);
  // On its thick side: the slot has one ceiling, below the thin wall.
  ASSERT_EQ(turned->overhangs.size(), 1U);
  EXPECT_NEAR(turned->overhang_area, 20 * 28 * mm2, 1e-15);
  EXPECT_NEAR(turned->overhangs[0].worst, 90 * degree, 1e-12);
  EXPECT_THAT(turned->overhangs[0].surfaces, ElementsAre(7));
}

/// 10 x 10 mm at the bottom; the wall x = max leans out by 45 degrees over 10 mm.
version_ptr wedge() {
  return test::box_mesh({1, 1, 1}, {10 * mm, 10 * mm, 10 * mm}, [](vec3 p) {
    return vec3{p.x + (p.x > 0 ? p.z : 0), p.y, p.z};
  });
}

TEST(PrintChecks, AWedgeLeansByFortyFiveDegrees) {
  const auto mesh = wedge();

  const auto allowed = check_print(*mesh, {.lean = 45 * degree});
  const auto strict = check_print(*mesh, {.lean = 44.9 * degree});

  EXPECT_TRUE(allowed->overhangs.empty());
  ASSERT_EQ(strict->overhangs.size(), 1U);
  EXPECT_NEAR(strict->overhang_area, 10 * std::sqrt(200) * mm2, 1e-15);
  EXPECT_NEAR(strict->overhangs[0].worst, 45 * degree, 1e-12);
  EXPECT_THAT(strict->overhangs[0].surfaces, ElementsAre(2));
  EXPECT_NEAR(strict->volume, 1500e-9, 1e-18);
}

TEST(PrintChecks, TheEdgeOfAWedgeIsNoThinWallThatOfABladeIs) {
  const auto wide = wedge();
  // A roof of 2 tan(5 degrees): both sides lean by 5 degrees and meet at the top.
  const double half = 20 * std::tan(5 * degree);
  const auto blade = test::box_mesh({2, 1, 20}, {2 * half * mm, 10 * mm, 20 * mm}, [&](vec3 p) {
    const double share = 1 - 0.99 * p.z / (20 * mm);
    return vec3{half * mm + (p.x - half * mm) * share, p.y, p.z};
  });

  EXPECT_TRUE(check_print(*wide, {.thinner_than = 1 * mm})->thin.empty());
  const auto report = check_print(*blade, {.thinner_than = 1 * mm});
  ASSERT_GE(report->thin.size(), 1U);
  // Straight in from a side that leans by 5 degrees, 1 mm is reached where the blade is about 1 mm.
  const double height = 1 / (2 * std::tan(5 * degree));
  EXPECT_NEAR(report->thin_area, 2 * 10 * height * mm2, 0.1 * 2 * 10 * height * mm2);
}

TEST(PrintChecks, CountsBodiesClosedVoidsAndHinges) {
  const auto hollow =
    test::blocks(3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; });
  const auto two = test::blocks({3, 1, 1}, [](int x, int, int) { return x != 1; });

  const auto hinge = test::blocks({2, 2, 1}, [](int x, int y, int) { return x == y; });
  const auto void_report = check_print(*hollow, {.thinner_than = 1.5});
  const auto two_report = check_print(*two, {});

  EXPECT_EQ(void_report->bodies, 1U);
  EXPECT_EQ(void_report->closed_voids, 1U);
  EXPECT_TRUE(void_report->has_findings());
  // The void's six faces of 1 m2, and what lies opposite to them.
  EXPECT_NEAR(void_report->thin_area, 12, 1e-9);
  EXPECT_EQ(check_print(*hinge, {})->hinge_edges, 1U);
  EXPECT_EQ(two_report->bodies, 2U);
  EXPECT_EQ(two_report->crossing_facets, 0U);
}

TEST(PrintChecks, BodiesThatPassThroughEachOtherAreFound) {
  // Two cubes apart in the mesh; the second one is moved half into the first.
  const auto mesh = test::blocks(
    {3, 1, 1}, [](int x, int, int) { return x != 1; },
    [](vec3 p) {
      return p.x < 1.5 ? p : vec3{p.x - 1.5, p.y + 0.25, p.z + 0.25};
    });

  const auto report = check_print(*mesh, {});

  EXPECT_TRUE(report->watertight());
  EXPECT_GT(report->crossing_facets, 0U);
  EXPECT_TRUE(report->has_findings());
}

TEST(PrintChecks, ADirectionNeedsALengthAndACancelIsHeard) {
  const auto mesh = wedge();

  EXPECT_EQ(check_print(*mesh, {.up = {0, 0, 0}}).error().code, ec::invalid_argument);
  execution run;
  run.cancel.cancel();
  EXPECT_EQ(check_print(*mesh, {}, run).error().code, ec::cancelled);
}

}  // namespace
}  // namespace tedit
