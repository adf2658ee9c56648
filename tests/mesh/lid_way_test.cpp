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

}  // namespace
}  // namespace tedit
