// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/exact_wall.hpp"

#include <cmath>
#include <numbers>

#include "gmock/gmock.h"
#include "mesh/features/torus_fit.hpp"

namespace tedit {
namespace {

constexpr double pi = std::numbers::pi;

/// Points of a surface over a grid of two angles, two triangles a cell.
template <class Place>
facet_corners grid(int rows, int columns, double row_angle, double column_angle,
                   const Place& place) {
  facet_corners result;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      result.points.push_back(place(row_angle * i / (rows - 1), column_angle * j / (columns - 1)));
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * columns + j); };
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      result.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      result.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
  return result;
}

const vec3 centre{0.11, -0.03, 0.27};
const vec3 axis = normalized(vec3{1, 2, -0.5});
const vec3 side = normalized(cross(axis, vec3{0, 0, 1}));
const vec3 other = cross(axis, side);

/// A fillet of 2 mm around a pin of 10 mm, askew in space; `squeeze`: along the axis.
vec3 on_fillet(double tube, double around, double squeeze = 1) {
  const double out = 0.010 - 0.002 * std::cos(tube);
  const double up = squeeze * 0.002 * std::sin(tube);
  return centre + out * (std::cos(around) * side + std::sin(around) * other) + up * axis;
}

TEST(Torus, AQuarterOfATubeIsFoundToRounding) {
  // Three rows of seven corners, over 120 degrees: as coarse as fillets are meshed.
  const auto found =
    fit_torus(grid(3, 7, pi / 2, 2 * pi / 3, [](double a, double b) { return on_fillet(a, b); }));

  ASSERT_TRUE(found);
  EXPECT_NEAR(norm(found->centre - centre), 0, 1e-12);
  EXPECT_NEAR(std::abs(dot(found->axis, axis)), 1, 1e-15);
  EXPECT_NEAR(found->radius, 0.010, 1e-12);
  EXPECT_NEAR(found->tube_radius, 0.002, 1e-12);
}

TEST(Torus, DistanceAndNormalAreThoseOfTheTube) {
  const auto wall =
    fit_exact(grid(5, 13, pi / 2, pi, [](double a, double b) { return on_fillet(a, b); }));

  ASSERT_TRUE(wall);
  EXPECT_FALSE(wall->flat());
  EXPECT_NEAR(wall->radius_at(centre), 0.002, 1e-12);
  // Its triangles look into the tube, whose middle is its radius off the material; the axis is
  // eight millimetres beyond the tube's skin.
  EXPECT_NEAR(wall->distance(centre + 0.010 * side), 0.002, 1e-12);
  EXPECT_NEAR(wall->distance(centre + 0.0005 * side), -0.0075, 1e-12);
  EXPECT_NEAR(wall->distance(centre + 0.010 * side + 0.003 * axis), -0.001, 1e-12);
  EXPECT_NEAR(dot(wall->normal(centre + 0.010 * side + 0.003 * axis), axis), -1, 1e-12);
}

TEST(Torus, AChordsMiddleIsPutOntoTheTube) {
  const auto wall =
    fit_exact(grid(4, 9, pi / 2, pi / 2, [](double a, double b) { return on_fillet(a, b); }));
  ASSERT_TRUE(wall);
  const vec3 middle = 0.5 * (on_fillet(0, 0.1) + on_fillet(pi / 6, 0.1));

  const auto place = place_on_walls({{&*wall, {}, {}, false}}, middle);

  ASSERT_TRUE(place.found);
  // A chord of 30 degrees is 2 mm (1 - cos 15 degrees) inside.
  EXPECT_NEAR(place.before, 0.002 * (1 - std::cos(pi / 12)), 1e-12);
  EXPECT_LT(place.after, 1e-15);
  EXPECT_NEAR(norm(place.at - on_fillet(pi / 12, 0.1)), 0, 1e-12);
}

TEST(Torus, WhatIsNoneIsNotTaken) {
  const auto squeezed = [](double a, double b) { return on_fillet(a, b, 0.9); };
  EXPECT_FALSE(fit_torus(grid(5, 9, pi / 2, pi, squeezed))) << "an ellipse";
  EXPECT_FALSE(
    fit_torus(grid(2, 9, pi / 2, pi, [](double a, double b) { return on_fillet(a, b); })))
    << "two circles are on many";
  EXPECT_FALSE(
    fit_torus(grid(3, 9, 0.7 * pi, pi, [](double a, double b) { return on_fillet(a, b); })))
    << "rows too far apart to be sure";
  auto dented = grid(5, 9, pi / 2, pi, [](double a, double b) { return on_fillet(a, b); });
  dented.points[20] += 1e-6 * axis;
  EXPECT_FALSE(fit_torus(dented)) << "a corner off by a two thousandth of the tube's radius";
  const auto flat = grid(4, 4, 1, 1, [](double a, double b) { return vec3{a, b, 0}; });
  EXPECT_FALSE(fit_torus(flat));
  facet_corners point;
  point.points.assign(12, centre);
  point.triangles.assign(4, {0, 1, 2});
  EXPECT_FALSE(fit_torus(point));
}

TEST(ExactWall, ABoxWithOneSurfaceIsNoSphere) {
  facet_corners box;
  for (int i = 0; i < 8; ++i)
    box.points.push_back(centre + 0.01 * vec3{double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

  EXPECT_FALSE(fit_exact(box)) << "its corners are on one";
}

TEST(ExactWall, SpheresAndCylindersStayWhatTheyAre) {
  const auto ball = fit_exact(grid(5, 9, pi / 2, pi / 2, [](double a, double b) {
    const double across = std::cos(a + 0.2);
    return centre +
           0.004 * (across * (std::cos(b) * side + std::sin(b) * other) + std::sin(a + 0.2) * axis);
  }));
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->sphere_radius, 0.004, 1e-12);
  EXPECT_EQ(ball->tube_radius, 0);
  const auto pin = fit_exact(grid(9, 9, pi, 0.01, [](double a, double b) {
    return centre + 0.004 * (std::cos(a) * side + std::sin(a) * other) + b * axis;
  }));
  ASSERT_TRUE(pin);
  EXPECT_EQ(pin->shape.type, wall_shape::kind::cylinder);
}

}  // namespace
}  // namespace tedit
