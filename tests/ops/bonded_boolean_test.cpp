// SPDX-License-Identifier: AGPL-3.0-or-later
// services::boolean on a block of two bonded regions, x < 1 and x > 1: volumes of each region and
// areas of the interface by hand.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "ops/boolean/boolean.hpp"
#include "ops/services/host_services.hpp"
#include "ops/tools/tools.hpp"
#include "tests/support/bonded_boxes.hpp"

namespace tedit::ops {
namespace {

using test::bond;
using test::boundary_area;
using test::volume_of;

version_ptr two_regions(bool named = true) {
  return test::bonded_boxes({12, 6, 6}, {2, 1, 1}, named);
}

double interface_area(const mesh_version& mesh) {
  double sum = 0;
  for (const auto& row : mesh.data().interfaces.to_vector()) {
    EXPECT_EQ(row.surface, bond);
    sum +=
      norm(area_vector(mesh.position(row.v[0]), mesh.position(row.v[1]), mesh.position(row.v[2])));
  }
  return sum;
}

/// Of a regular polygon of 24 corners.
double circle_area(double radius) {
  return 12 * radius * radius * std::sin(std::numbers::pi / 12);
}

class Bonded : public ::testing::Test {
protected:
  tool_surface brick(vec3 low, vec3 size) {
    const frame f = make_frame(low + 0.5 * vec3{size.x, size.y, 0}, {0, 0, 1}, {0, 1, 0});
    auto tool = extrude(f, rectangle(size.x, size.y), 0, size.z, 0.15, "brick", *host_);
    EXPECT_TRUE(tool);
    return *tool;
  }

  static tool_surface rod(vec3 from, vec3 along, double radius, double length) {
    return revolve(make_frame(from + length * along, along),
                   {{0, 0, ""}, {radius, 0, "top"}, {radius, -length, "side"}, {0, -length, "end"}},
                   24, 0.15);
  }

  version_ptr made(const version_ptr& mesh, const tool_surface& tool, boolean_mode mode) {
    const auto result = host_->boolean(mesh, tool, {mode, 0}, {});
    EXPECT_TRUE(result) << render(result.error());
    if (!result)
      return mesh;
    edit_claim claim;
    claim.touched = result->touched;
    claim.volume_change = result->volume_change;
    claim.quality_floor = lowest_boolean_quality;
    const auto report = check_edit(*mesh, *result->candidate, claim);
    EXPECT_TRUE(report.ok()) << to_error(report).message;
    EXPECT_EQ(check_version(*result->candidate).total, 0u);
    return result->candidate;
  }

  std::unique_ptr<services> host_ = make_host_services();
  version_ptr block_ = two_regions();
};

TEST_F(Bonded, AHoleAlongBothTakesOfBothAndOfWhatIsBetween) {
  const auto cut = made(block_, rod({-1, 0.5, 0.5}, {1, 0, 0}, 0.2, 4), boolean_mode::cut);

  EXPECT_NEAR(volume_of(*cut, 1), 1 - circle_area(0.2), 1e-12);
  EXPECT_NEAR(volume_of(*cut, 2), 1 - circle_area(0.2), 1e-12);
  EXPECT_NEAR(interface_area(*cut), 1 - circle_area(0.2), 1e-12);
}

TEST_F(Bonded, WhatNearlyMeetsTheInterfaceGetsRoomBeyondIt) {
  // A post on one of them ends 10 mm before the other, among edges of 167 mm.
  const auto tool = brick({0.6, 0.3, 1}, {0.39, 0.4, 0.2});
  const auto result = host_->boolean(block_, tool, {boolean_mode::add, 0}, {});

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_GE(result->worst_after, 0.1);
  EXPECT_EQ(check_version(*result->candidate).total, 0u);
  EXPECT_NEAR(volume_of(*result->candidate, 1), 1 + 0.39 * 0.4 * 0.2, 1e-12);
  EXPECT_NEAR(volume_of(*result->candidate, 2), 1, 1e-12);
  EXPECT_NEAR(interface_area(*result->candidate), 1, 1e-12);
}

TEST_F(Bonded, AHoleThatIsTiltedGoesThroughBothExactly) {
  const auto tool = rod({0.4, 0.5, -0.7}, normalized({0.5, 0.05, 1}), 0.15, 4);

  const auto cut = made(block_, tool, boolean_mode::cut);
  const auto kept = made(block_, tool, boolean_mode::keep);

  for (const region_id region : {1, 2}) {
    EXPECT_LT(volume_of(*cut, region), 1);
    EXPECT_NEAR(volume_of(*cut, region) + volume_of(*kept, region), 1, 1e-9);
  }
  EXPECT_NEAR(interface_area(*cut) + interface_area(*kept), 1, 1e-9);
}

TEST_F(Bonded, ACutThatEndsAtTheInterfaceLeavesTheOtherOneAWallThere) {
  const auto cut = made(block_, brick({0.6, 0.3, 0.5}, {0.4, 0.4, 1}), boolean_mode::cut);

  EXPECT_NEAR(volume_of(*cut, 1), 1 - 0.4 * 0.4 * 0.5, 1e-12);
  EXPECT_NEAR(volume_of(*cut, 2), 1, 1e-12);
  EXPECT_NEAR(interface_area(*cut), 1 - 0.4 * 0.5, 1e-12);
  EXPECT_NEAR(boundary_area(*cut, bond), 0.4 * 0.5, 1e-12);
}

TEST_F(Bonded, WhatWasAlikeOnBothSidesOfTheCutStaysSo) {
  // A slot right across the seam, open at the top.
  const auto cut = made(block_, brick({0.7, 0.3, 0.6}, {0.6, 0.4, 1}), boolean_mode::cut);

  EXPECT_NEAR(volume_of(*cut, 1), 1 - 0.3 * 0.4 * 0.4, 1e-12);
  EXPECT_NEAR(volume_of(*cut, 2), 1 - 0.3 * 0.4 * 0.4, 1e-12);
  EXPECT_NEAR(interface_area(*cut), 1 - 0.4 * 0.4, 1e-12);
}

TEST_F(Bonded, AnAdditionIsPartOfTheOneThatMostOfItStandsOn) {
  const auto one = made(block_, brick({0.5, 0.3, 1}, {0.7, 0.4, 0.3}), boolean_mode::add);
  const auto other = made(block_, brick({0.8, 0.3, 1}, {0.7, 0.4, 0.3}), boolean_mode::add);

  EXPECT_NEAR(volume_of(*one, 1), 1 + 0.7 * 0.4 * 0.3, 1e-12);
  EXPECT_NEAR(volume_of(*one, 2), 1, 1e-12);
  EXPECT_NEAR(volume_of(*other, 1), 1, 1e-12);
  EXPECT_NEAR(volume_of(*other, 2), 1 + 0.7 * 0.4 * 0.3, 1e-12);
}

TEST_F(Bonded, AnAdditionIsBondedToTheOtherOne) {
  const auto added =
    host_->boolean(block_, brick({0.5, 0.3, 0.9}, {0.7, 0.4, 0.3}), {boolean_mode::add, 0}, {});

  ASSERT_TRUE(added) << render(added.error());
  const auto& mesh = *added->candidate;
  EXPECT_EQ(check_version(mesh).total, 0u);
  // What it would share with region 2 is left to region 2.
  EXPECT_NEAR(volume_of(mesh, 1), 1 + 0.7 * 0.4 * 0.2, 1e-12);
  EXPECT_NEAR(volume_of(mesh, 2), 1, 1e-12);
  double bonded = 0;
  for (const auto& row : mesh.data().interfaces.to_vector())
    bonded +=
      norm(area_vector(mesh.position(row.v[0]), mesh.position(row.v[1]), mesh.position(row.v[2])));
  EXPECT_NEAR(bonded, 1 + 0.2 * 0.4, 1e-12);
}

TEST_F(Bonded, AnInterfaceWithoutAnIdStaysBondedToo) {
  const auto cut =
    made(two_regions(false), rod({-1, 0.5, 0.5}, {1, 0, 0}, 0.2, 4), boolean_mode::cut);

  EXPECT_NEAR(volume_of(*cut, 1), 1 - circle_area(0.2), 1e-12);
  EXPECT_NEAR(volume_of(*cut, 2), 1 - circle_area(0.2), 1e-12);
}

TEST_F(Bonded, AnInterfaceWithoutAnIdIsANewSurfaceWhereItIsLaidBare) {
  const auto unnamed = two_regions(false);

  const auto cut = made(unnamed, brick({0.6, 0.3, 0.5}, {0.4, 0.4, 1}), boolean_mode::cut);

  const auto& rows = cut->surfaces();
  const auto bare = std::ranges::find(rows, "between region 1 and region 2", &surface_info::name);
  ASSERT_NE(bare, rows.end());
  EXPECT_FALSE(unnamed->find_surface(bare->id));
  EXPECT_NEAR(boundary_area(*cut, bare->id), 0.4 * 0.5, 1e-12);
  EXPECT_NEAR(volume_of(*cut, 1), 1 - 0.4 * 0.4 * 0.5, 1e-12);
  EXPECT_NEAR(volume_of(*cut, 2), 1, 1e-12);
}

TEST_F(Bonded, AHoleBesideTheInterfaceIsNoneOfTheOtherRegions) {
  const auto cut = made(block_, rod({0.4, 0.5, -1}, {0, 0, 1}, 0.15, 3), boolean_mode::cut);

  EXPECT_NEAR(volume_of(*cut, 1), 1 - circle_area(0.15), 1e-12);
  EXPECT_EQ(volume_of(*cut, 2), volume_of(*block_, 2));
  EXPECT_EQ(interface_area(*cut), interface_area(*block_));
}

}  // namespace
}  // namespace tedit::ops
