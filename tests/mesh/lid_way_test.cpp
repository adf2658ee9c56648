// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/lid_way.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace tedit {
namespace {

using kind = surface_geometry::kind;

constexpr vec3 up{0, 0, 1};
constexpr vec3 tilted{0.6, 0, 0.8};

surface_geometry wall(kind type, vec3 axis) {
  surface_geometry result;
  result.type = type;
  result.axis = axis;
  return result;
}

/// A square in the plane of the lid.
const std::vector<std::array<vec3, 2>> rim{{vec3{1, 0, 0}, vec3{0, 1, 0}},
                                           {vec3{0, 1, 0}, vec3{-1, 0, 0}},
                                           {vec3{-1, 0, 0}, vec3{0, -1, 0}},
                                           {vec3{0, -1, 0}, vec3{1, 0, 0}}};

TEST(WayPastLid, IsTheAxisOfATiltedBore) {
  EXPECT_EQ(way_past_lid(std::array{wall(kind::cylinder, tilted)}, up, rim), tilted);
  EXPECT_EQ(way_past_lid(std::array{wall(kind::cylinder, -tilted)}, up, rim), tilted);
}

TEST(WayPastLid, IsWherePlanesMeet) {
  // Of a tilted slot: its sides look along y, its ends across the tilt.
  const std::array slot{wall(kind::plane, {0, 1, 0}), wall(kind::plane, {0.8, 0, -0.6}),
                        wall(kind::plane, {0, -1, 0})};

  const vec3 way = way_past_lid(slot, up, rim);

  EXPECT_NEAR(norm(way - tilted), 0, 1e-15);
}

TEST(WayPastLid, IsStraightOutWhereWallsGoNoOneWay) {
  const std::array slot_in_a_wedge{wall(kind::plane, {0, 1, 0}), wall(kind::plane, {0.8, 0, -0.6}),
                                   wall(kind::plane, {1, 0, 0})};

  EXPECT_EQ(way_past_lid(slot_in_a_wedge, up, rim), up);
  EXPECT_EQ(way_past_lid(std::array{wall(kind::cone, up)}, tilted, rim), tilted);
  EXPECT_EQ(way_past_lid(std::array{wall(kind::plane, {1, 0, 0})}, up, rim), up);
  EXPECT_EQ(way_past_lid({}, up, rim), up);
}

TEST(WayPastLid, IsStraightOutWhereTheWallsLeadOutAtNoAngleOrTheHoleIsOpenAtItsSide) {
  EXPECT_EQ(way_past_lid(std::array{wall(kind::cylinder, {0.99, 0, 0.141})}, up, rim), up);

  auto open = rim;
  open[0] = {vec3{1, 0, 0}, vec3{1, 0, 0} + tilted};
  EXPECT_EQ(way_past_lid(std::array{wall(kind::cylinder, tilted)}, up, open), up);
}

TEST(ReachOfHole, GoesOutOfTheMaterialAndABitIntoTheOpen) {
  using rays = std::vector<std::vector<lid_hit>>;
  // The rim is on the surface, below 3 and below 5 of material; half an edge of 2 further.
  EXPECT_DOUBLE_EQ(reach_of_hole(rays{{}, {{3, true}}, {{5, true}}}, 2), 6);
  // 8 of free space do not matter, of 1.2 half is taken.
  EXPECT_DOUBLE_EQ(reach_of_hole(rays{{{5, true}, {13, false}, {14, true}}}, 2), 6);
  EXPECT_DOUBLE_EQ(reach_of_hole(rays{{{5, true}, {6.2, false}, {14, true}}}, 2), 5.6);
  // What is above another point of the rim counts, too, where it is not passed already.
  EXPECT_DOUBLE_EQ(reach_of_hole(rays{{{5, true}}, {{5.4, false}, {9, true}}}, 2), 5.2);
  EXPECT_DOUBLE_EQ(reach_of_hole(rays{{{5, true}}, {{4.4, false}, {9, true}}}, 2), 6);
  EXPECT_DOUBLE_EQ(reach_of_hole({}, 2), 1);
}

}  // namespace
}  // namespace tedit
