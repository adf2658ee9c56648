// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/distances.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tedit {
namespace {

TEST(Distances, OfATriangleIsThatToItsPlaneItsEdgesOrItsCorners) {
  const vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};

  EXPECT_DOUBLE_EQ(point_to_triangle({.25, .25, -2}, a, b, c), 2);
  EXPECT_DOUBLE_EQ(point_to_triangle({.5, -3, 4}, a, b, c), 5);
  EXPECT_DOUBLE_EQ(point_to_triangle({-2, -3, 6}, a, b, c), 7);
  EXPECT_DOUBLE_EQ(point_to_triangle({1, 1, 0}, a, b, c), std::sqrt(.5));
}

TEST(Distances, OfATriangleWithoutAreaIsThatToItsEdges) {
  const vec3 a{0, 0, 0}, b{1, 0, 0}, c{2, 0, 0};

  EXPECT_DOUBLE_EQ(point_to_triangle({1.5, 2, 0}, a, b, c), 2);
}

TEST(Distances, OfSegmentsThatCrossLieApartOrArePoints) {
  const vec3 o{0, 0, 0}, x{2, 0, 0};
  EXPECT_DOUBLE_EQ(segments_apart(o, x, {1, -1, 3}, {1, 1, 3}), 3);
  EXPECT_DOUBLE_EQ(segments_apart(o, x, {5, 4, 0}, {9, 4, 0}), 5);
  EXPECT_DOUBLE_EQ(segments_apart(o, o, x, x), 2);
}

}  // namespace
}  // namespace tedit
