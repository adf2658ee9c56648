// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/spline_surface.hpp"

#include <cmath>
#include <limits>

#include "gmock/gmock.h"

namespace tedit {
namespace {

/// A quarter of a cylinder of radius 1 around z, 2 high: rational quadratics by linear functions.
spline_surface quarter() {
  spline_surface s;
  s.degree = {2, 1};
  s.knots = {{{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}}};
  s.poles = {{1, 0, 0}, {1, 0, 2}, {1, 1, 0}, {1, 1, 2}, {0, 1, 0}, {0, 1, 2}};
  const double w = std::sqrt(0.5);
  s.weights = {1, 1, w, w, 1, 1};
  return s;
}

/// z = x^2 over [-1, 1] by [0, 1], in two spans: exactly a quadratic.
spline_surface parabola() {
  spline_surface s;
  s.degree = {2, 1};
  s.knots = {{{-1, -1, -1, 0, 1, 1, 1}, {0, 0, 1, 1}}};
  // Poles are the blossom at pairs of knots: x is their mean, z their product.
  for (const auto& [a, b] : {std::pair{-1, -1}, {-1, 0}, {0, 1}, {1, 1}})
    for (const double y : {0.0, 1.0})
      s.poles.push_back({(a + b) / 2.0, y, double(a * b)});
  return s;
}

TEST(SplineSurface, ARationalQuadraticIsTheCircle) {
  const auto s = quarter();
  for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    const auto here = s(u, 0.25);
    EXPECT_NEAR(std::hypot(here.at.x, here.at.y), 1, 1e-15);
    EXPECT_NEAR(here.at.z, 0.5, 1e-15);
    EXPECT_NEAR(dot(here.along_u, {here.at.x, here.at.y, 0}), 0, 1e-14);
    EXPECT_NEAR(norm(here.along_v - vec3{0, 0, 2}), 0, 1e-14);
  }
}

TEST(SplineSurface, DerivativesAreThoseOfThePolynomial) {
  const auto s = parabola();
  for (const double x : {-1.0, -0.3, 0.0, 0.4, 1.0}) {
    const auto here = s(x, 0.5);
    EXPECT_NEAR(norm(here.at - vec3{x, 0.5, x * x}), 0, 1e-15);
    EXPECT_NEAR(norm(here.along_u - vec3{1, 0, 2 * x}), 0, 1e-14);
    EXPECT_NEAR(norm(here.along_v - vec3{0, 1, 0}), 0, 1e-15);
  }
}

TEST(SplineProjection, FindsTheFootOfAPointOnItsNormal) {
  const auto surface = parabola();
  const spline_projection project(surface);
  for (const double x : {-0.8, -0.1, 0.0, 0.5}) {
    const vec3 foot{x, 0.3, x * x};
    const vec3 normal = normalized(vec3{-2 * x, 0, 1});
    for (const double off : {-0.1, 0.0, 0.2}) {
      const auto found = project(foot + off * normal);
      EXPECT_NEAR(norm(found.at - foot), 0, 1e-13) << x << " " << off;
      EXPECT_NEAR(norm(found.normal - normal), 0, 1e-12);
    }
  }
}

TEST(SplineProjection, StaysOnTheSurfaceBeyondItsRim) {
  const auto surface = quarter();
  const spline_projection project(surface);

  // Beyond both rims at once, and beyond one.
  EXPECT_NEAR(norm(project({2, -1, 3}).at - vec3{1, 0, 2}), 0, 1e-14);
  EXPECT_NEAR(norm(project({2, 2, -1}).at - vec3{std::sqrt(0.5), std::sqrt(0.5), 0}), 0, 1e-12);
}

TEST(SplineProjection, KnowsHowMuchTheSurfaceBends) {
  EXPECT_NEAR(spline_projection(quarter()).least_radius(), 1, 1e-2);
  // The mean of a step of the grid: a little more than at the vertex alone.
  EXPECT_NEAR(spline_projection(parabola()).least_radius(), 0.53, 0.04);
}

TEST(SplineSurface, WhatCannotBeIsToldApart) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto good = parabola();
  const auto refuses = [&](const auto& change) {
    auto s = good;
    change(s);
    return !is_possible(s);
  };

  EXPECT_TRUE(is_possible(good));
  EXPECT_TRUE(is_possible(quarter()));
  EXPECT_TRUE(refuses([](auto& s) { s.degree[0] = 0; }));
  EXPECT_TRUE(refuses([](auto& s) { s.degree[0] = 26; }));
  EXPECT_TRUE(refuses([](auto& s) { s.degree[1] = 3; }));
  EXPECT_TRUE(refuses([](auto& s) { s.knots[0].clear(); }));
  EXPECT_TRUE(refuses([](auto& s) { std::swap(s.knots[0][2], s.knots[0][3]); }));
  EXPECT_TRUE(refuses([](auto& s) { s.knots[0][3] = HUGE_VAL; }));
  EXPECT_TRUE(refuses([](auto& s) { s.knots[1] = {0, 0, 0, 0}; }));
  // A knot that counts four times lets a basis function vanish: a division of nothing by nothing.
  EXPECT_TRUE(refuses([](auto& s) { s.knots[0] = {-1, -1, -1, -1, 1, 1, 1}; }));
  EXPECT_TRUE(refuses([](auto& s) { s.poles.pop_back(); }));
  EXPECT_TRUE(refuses([none](auto& s) { s.poles[3].y = none; }));
  EXPECT_TRUE(refuses([](auto& s) { s.weights = {1, 1}; }));
  EXPECT_TRUE(refuses([](auto& s) { s.weights.assign(8, 0); }));
  EXPECT_TRUE(refuses([none](auto& s) { s.weights.assign(8, none); }));
}

}  // namespace
}  // namespace tedit
