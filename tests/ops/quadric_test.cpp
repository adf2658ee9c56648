// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/caps/quadric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tedit::ops {
namespace {

/// A quarter of a cylinder of radius 2 mm around the z axis through (1, 0, 0) mm.
std::vector<vec3> quarter_cylinder() {
  std::vector<vec3> points;
  for (int i = 0; i <= 4; ++i)
    for (int k = 0; k <= 3; ++k) {
      const double angle = 0.4 * i;
      points.push_back({1e-3 + 2e-3 * std::cos(angle), 2e-3 * std::sin(angle), 1e-3 * k});
    }
  return points;
}

TEST(Quadric, FitsACylinderExactly) {
  const auto shape = fit_quadric(quarter_cylinder());

  ASSERT_TRUE(shape.has_value());
  EXPECT_NEAR(shape->distance({1e-3, 2e-3, 0.5e-3}), 0, 1e-12);
  // From (1, 1, 1) mm along y the cylinder is 1 mm away, and 3 mm the other way: the nearer counts.
  const auto way = shape->along({1e-3, 1e-3, 1e-3}, {0, 1, 0});
  ASSERT_TRUE(way.has_value());
  EXPECT_NEAR(*way, 1e-3, 1e-12);
  EXPECT_FALSE(shape->along({4e-3, 0, 0}, {0, 1, 0}).has_value()) << "this line misses it";
}

TEST(Quadric, FewPointsGiveNone) {
  const auto points = quarter_cylinder();
  EXPECT_FALSE(fit_quadric(std::span(points).first(9)).has_value());
}

TEST(Quadric, PointsOfAQuarticAreOffTheirs) {
  std::vector<vec3> points;
  for (int i = -3; i <= 3; ++i)
    for (int k = -3; k <= 3; ++k)
      points.push_back({1.0 * i, 1.0 * k, 0.01 * (i * i * i * i - k * k * k * k)});
  const auto shape = fit_quadric(points);
  ASSERT_TRUE(shape.has_value());
  double off = 0;
  for (const auto& p : points)
    off = std::max(off, shape->distance(p));
  EXPECT_GT(off, 0.05);
}

}  // namespace
}  // namespace tedit::ops
