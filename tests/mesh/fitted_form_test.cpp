// SPDX-License-Identifier: AGPL-3.0-or-later
// Walls are heights over a grid of corners 0.1 apart, cut into triangles along one diagonal.
#include "mesh/features/fitted_form.hpp"

#include <cmath>
#include <functional>

#include "gmock/gmock.h"

namespace tedit {
namespace {

constexpr double edge_length = 0.1;

using height = std::function<double(double x, double y)>;

facet_corners wall(int along_x, int along_y, const height& z) {
  facet_corners result;
  for (int j = 0; j <= along_y; ++j)
    for (int i = 0; i <= along_x; ++i)
      result.points.push_back(
        {i * edge_length, j * edge_length, z(i * edge_length, j * edge_length)});
  const auto corner = [&](int i, int j) {
    return static_cast<std::uint32_t>(j * (along_x + 1) + i);
  };
  for (int j = 0; j < along_y; ++j)
    for (int i = 0; i < along_x; ++i) {
      result.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      result.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  return result;
}

double dome(double x, double y) {
  return 0.3 * std::sin(2 * x) * std::cos(1.5 * y);
}

/// The furthest that what is above or below the middles of edges and facets is off the heights, on
/// the facets and on the fitted surface.
struct offs {
  double facets = 0;
  double fitted = 0;
};
offs furthest_off(const facet_corners& facets, const fitted_form& form, const height& z) {
  offs result;
  const auto look = [&](vec3 p) {
    const auto off = [&](vec3 at) { return std::abs(at.z - z(at.x, at.y)); };
    result.facets = std::max(result.facets, off(p));
    result.fitted = std::max(result.fitted, off(form(p).at));
  };
  for (const auto& t : facets.triangles) {
    const auto& p = facets.points;
    look((p[t[0]] + p[t[1]] + p[t[2]]) / 3);
    for (int k = 0; k < 3; ++k)
      look(0.5 * (p[t[k]] + p[t[(k + 1) % 3]]));
  }
  return result;
}

TEST(FittedForm, IsMuchNearerToASmoothWallThanItsFacets) {
  const auto facets = wall(10, 8, dome);
  const auto form = fitted_form::through(facets);
  ASSERT_TRUE(form);
  const auto off = furthest_off(facets, *form, dome);
  // An edge of 0.141 bends by about 1/R = 1: its middle is off by l^2 / 8.
  EXPECT_NEAR(off.facets, 0.0025, 0.0005);
  EXPECT_LT(off.fitted, off.facets / 25);
  // The bend is at most that of the sine, f'' / (1 + f'^2)^(3/2) <= 1.2.
  const vec3 top{0.8, 0.1, dome(0.8, 0.1)};
  EXPECT_GT(form->radius_at(top), 0.7);
  EXPECT_LT(form->radius_at(top), 1.2);
}

/// Of a radius of 1: chords of 0.1 are off by 1 - cos(0.05) = 1.25e-3 and more.
TEST(FittedForm, AnEdgeOfARoundWallIsNearlyAnArc) {
  const auto facets = wall(10, 8, [](double x, double) { return std::sqrt(1 - x * x / 4); });
  const auto form = fitted_form::through(facets);
  ASSERT_TRUE(form);
  const auto off = [](vec3 p) { return std::abs(std::hypot(p.x / 2, p.z) - 1); };
  for (std::uint32_t v = 4 * 11 + 2; v < 4 * 11 + 8; ++v) {
    const vec3 middle = 0.5 * (facets.points[v] + facets.points[v + 1]);
    EXPECT_LT(off((*form)(middle).at), off(middle) / 100);
  }
}

TEST(FittedForm, HasAllCornersOnItAndLooksAwayFromTheMaterial) {
  const auto facets = wall(10, 8, dome);
  const auto form = fitted_form::through(facets);
  ASSERT_TRUE(form);
  for (const auto& p : facets.points) {
    const auto foot = (*form)(p);
    EXPECT_LT(norm(foot.at - p), 1e-15);
    EXPECT_GT(foot.normal.z, 0.8);
  }
}

TEST(FittedForm, FindsTheFootOfAPointOnItsNormal) {
  const auto form = fitted_form::through(wall(10, 8, dome));
  ASSERT_TRUE(form);
  for (const double x : {0.31, 0.5, 0.777})
    for (const double y : {0.25, 0.4, 0.61}) {
      const auto foot = (*form)({x, y, dome(x, y)});
      for (const double away : {-0.05, 0.03}) {
        const auto again = (*form)(foot.at + away * foot.normal);
        EXPECT_LT(norm(again.at - foot.at), 1e-12) << x << " " << y << " " << away;
        EXPECT_LT(norm(again.normal - foot.normal), 1e-11);
      }
    }
}

TEST(FittedForm, GoesOnStraightPastItsRim) {
  const auto form = fitted_form::through(wall(10, 8, [](double x, double) { return 0.5 * x * x; }));
  ASSERT_TRUE(form);
  const auto rim = (*form)({1, 0.4, 0.5});
  const vec3 along{rim.normal.z, 0, -rim.normal.x};
  const auto foot = (*form)({1 + 0.02 * along.x, 0.4, 0.5 + 0.02 * along.z});
  EXPECT_LT(norm(foot.at - vec3{1, 0.4, 0.5}), 1e-12);
}

/// Both planes are what they are, and nothing is rounded between them.
TEST(FittedForm, LeavesCreasesAsTheyAre) {
  for (const double slope : {0.05, 0.3, 1.0}) {
    const auto roof = [&](double x, double) { return -slope * std::abs(x - 0.5); };
    const auto facets = wall(10, 8, roof);
    const auto form = fitted_form::through(facets);
    ASSERT_TRUE(form);
    EXPECT_LT(furthest_off(facets, *form, roof).fitted, 1e-15) << slope;
    EXPECT_FALSE(fitted_form::near(facets, box{{0.45, 0.3, -1}, {0.48, 0.4, 1}}));
    EXPECT_TRUE(fitted_form::near(facets, box{{0.05, 0.3, -1}, {0.18, 0.4, 1}}));
  }
}

TEST(FittedForm, SaysNothingOfThreeRowsOfCorners) {
  const auto strip = [](double, double y) { return -0.3 * std::abs(y - 0.1); };
  const box within{{0.4, 0.04, -1}, {0.6, 0.06, 1}};
  EXPECT_FALSE(fitted_form::near(wall(10, 2, strip), within));
  EXPECT_FALSE(fitted_form::near(wall(10, 1, dome), within));
  EXPECT_TRUE(fitted_form::near(wall(10, 3, dome), within));
  EXPECT_FALSE(fitted_form::through({}));
  const auto facets = wall(10, 2, strip);
  EXPECT_LT(furthest_off(facets, *fitted_form::through(facets), strip).fitted, 1e-15);
}

TEST(FittedForm, TakesNoNoiseForASmoothWall) {
  std::uint32_t state = 1;
  const auto noise = [&](double, double) {
    state = state * 1664525 + 1013904223;
    return 0.01 * (state >> 16) / 65536.0;
  };
  const auto facets = wall(20, 20, noise);
  EXPECT_FALSE(fitted_form::near(facets, box{{0.5, 0.5, -1}, {1.5, 1.5, 1}}));
}

TEST(FittedForm, NearABoxIsWhatItIsOfTheWhole) {
  const auto facets = wall(40, 40, dome);
  const auto whole = fitted_form::through(facets);
  const auto part = fitted_form::near(facets, box{{1.0, 1.0, -1}, {1.2, 1.3, 1}});
  ASSERT_TRUE(whole);
  ASSERT_TRUE(part);
  for (const double x : {0.85, 1.03, 1.17, 1.36}) {
    const vec3 p{x, 1.11, dome(x, 1.11)};
    EXPECT_EQ((*part)(p).at, (*whole)(p).at);
  }
}

/// Files have such, too.
TEST(FittedForm, FacetsWithoutAnAreaDoNoHarm) {
  auto facets = wall(10, 8, dome);
  facets.triangles.insert(facets.triangles.begin(), {5, 6, 6});
  facets.triangles.push_back({5, 5, 5});
  const auto form = fitted_form::through(facets);
  ASSERT_TRUE(form);
  for (const auto& p : facets.points)
    EXPECT_LT(norm((*form)(p).at - p), 1e-15);
}

}  // namespace
}  // namespace tedit
