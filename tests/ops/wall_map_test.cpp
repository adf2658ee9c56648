// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/wall_map.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/features/round_fit.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::test {
namespace {

using std::numbers::pi;

/// A slab of 12 x 8 cells whose top, surface 6, is `place` of [0, 1] x [0, 1] x {1}.
version_ptr bent(const std::function<vec3(double u, double v, double depth)>& place) {
  return box_mesh({12, 8, 1}, {1, 1, 1}, [&](vec3 p) { return place(p.x, p.y, p.z); });
}

/// Each facet of the top looks up in the picture, and each corner comes back to where it was.
void expect_true_picture(const version_ptr& mesh, const std::vector<facet_id>& facets) {
  const auto wall = fit_exact(corners_of(*mesh, facets_of(*mesh, std::array<surface_id, 1>{6})));
  ASSERT_TRUE(wall);
  const ops::wall_map map(*mesh, *wall, facets);
  for (const auto f : facets) {
    std::array<std::array<double, 2>, 3> flat;
    for (int i = 0; i < 3; ++i) {
      const vec3 p = mesh->position(mesh->facet(f).v[i]);
      flat[i] = map.flatten(p);
      EXPECT_LT(norm(map.lift(flat[i]) - p), 1e-9) << "facet " << f;
    }
    const double area = (flat[1][0] - flat[0][0]) * (flat[2][1] - flat[0][1]) -
                        (flat[2][0] - flat[0][0]) * (flat[1][1] - flat[0][1]);
    EXPECT_GT(area, 0) << "facet " << f;
  }
}

void expect_true_picture(const version_ptr& mesh) {
  expect_true_picture(mesh, facets_of(*mesh, std::array<surface_id, 1>{6}));
}

/// About z: by `angle` at distance `rho`.
vec3 turned(double rho, double angle, double z) {
  return {rho * std::cos(angle), rho * std::sin(angle), z};
}

TEST(WallMap, APieceOfACylinderAConeASphereOrATorusIsUnrolled) {
  expect_true_picture(bent([](double u, double v, double d) { return turned(2 + d, 2 * u, v); }));
  expect_true_picture(
    bent([](double u, double v, double d) { return turned(2 + d + 0.5 * v, 2 * u, v); }));
  expect_true_picture(bent([](double u, double v, double d) {
    return (2 + d) * turned(std::cos(v), 2 * u, std::sin(v));
  }));
  expect_true_picture(bent([](double u, double v, double d) {
    return turned(8 + (1 + d) * std::cos(2 * v), 2 * u, (1 + d) * std::sin(2 * v));
  }));
}

TEST(WallMap, WallsOfHolesKeepTheirOrientation) {
  expect_true_picture(bent([](double u, double v, double d) { return turned(4 - d, -2 * u, v); }));
  expect_true_picture(
    bent([](double u, double v, double d) { return turned(4 - d + 0.5 * v, -2 * u, v); }));
  expect_true_picture(bent([](double u, double v, double d) {
    return (4 - d) * turned(std::cos(v), -2 * u, std::sin(v));
  }));
  expect_true_picture(bent([](double u, double v, double d) {
    return turned(8 + (3 - d) * std::cos(2 * v), -2 * u, (3 - d) * std::sin(2 * v));
  }));
}

TEST(WallMap, WhatGoesAllAroundBecomesARing) {
  // A turn less the width of a crack, which is narrower than a map takes notice of.
  const double all = 2 * pi - 1e-4;
  expect_true_picture(
    bent([&](double u, double v, double d) { return turned(2 + d + 0.5 * v, all * u, v); }));
  expect_true_picture(bent([&](double u, double v, double d) {
    return turned(8 + (1 + d) * std::cos(2 * v), all * u, (1 + d) * std::sin(2 * v));
  }));
  // Around the tube, for a part of the torus.
  expect_true_picture(bent([&](double u, double v, double d) {
    return turned(8 + (1 + d) * std::cos(all * u), -v, (1 + d) * std::sin(all * u));
  }));
}

}  // namespace
}  // namespace tedit::test
