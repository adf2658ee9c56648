// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/predicates.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tedit {
namespace {

TEST(Orient3d, HasTheSignOfTheDeterminant) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}), 0);
}

TEST(Orient3d, IsExactWhereRoundingWouldDecide) {
  const double next = std::nextafter(0.3, 1);

  // The plane x = y; the last point is on it or one unit in the last place off.
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0.3, 0.3, 0.7}), 0);
  EXPECT_NE(orient3d({0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {next, 0.3, 0.7}), 0);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {next, 0.3, 0.7}),
            -orient3d({0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0.3, next, 0.7}));
}

TEST(Orient3d, WorksAtAnyScale) {
  for (const double s : {1e-12, 1e-6, 1.0, 1e6, 1e12})
    EXPECT_EQ(orient3d({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}), 1) << s;
}

TEST(Norm, NeverHidesAComponentThatIsNoNumber) {
  const double nan = std::nan("");
  for (const vec3 v : {vec3{nan, 0, 0}, {0, nan, 0}, {0, 0, nan}, {3, 0, nan}, {nan, nan, nan}})
    EXPECT_TRUE(std::isnan(norm(v)));
  EXPECT_EQ(norm({0, 0, 0}), 0);
  EXPECT_EQ(norm({3, 0, -4}), 5);
}

TEST(Orient3d, APointThatIsNoNumberHasNoSide) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, bad}), 0);
    EXPECT_EQ(orient3d({bad, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0);
  }
}

TEST(TrianglesIntersect, TellsTouchingFromApart) {
  const std::array<vec3, 3> a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

  EXPECT_TRUE(triangles_intersect(a, {{{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.3, 0.3, 1}}}));
  EXPECT_TRUE(triangles_intersect(a, {{{1, 0, 0}, {2, 0, 0}, {2, 1, 1}}}));
  EXPECT_FALSE(triangles_intersect(a, {{{0, 0, 1e-12}, {1, 0, 1e-12}, {0, 1, 1e-12}}}));
}

}  // namespace
}  // namespace tedit
