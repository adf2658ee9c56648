// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/star_energy.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/quality.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

/// An equilateral rim of side 1 around the origin and two apices at +-height.
struct bipyramid {
  std::array<vec3, 3> rim;
  vec3 d, e;

  explicit bipyramid(double height) : d{0, 0, height}, e{0, 0, -height} {
    for (int i = 0; i < 3; ++i)
      rim[i] = {std::cos(2 * M_PI * i / 3) / std::sqrt(3),
                std::sin(2 * M_PI * i / 3) / std::sqrt(3), 0};
  }

  [[nodiscard]] double energy_of_two() const {
    return harmonic_energy({rim[0], rim[1], rim[2], d}) +
           harmonic_energy({rim[0], rim[2], rim[1], e});
  }

  [[nodiscard]] double energy_of_three() const {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += harmonic_energy({e, rim[i], rim[(i + 1) % 3], d});
    return sum;
  }
};

TEST(FlipWeight, TwoRegularTetsStayTwo) {
  const bipyramid regular(std::sqrt(2.0 / 3));
  double scale = 0;

  const double weight = flip_weight(regular.rim, regular.d, regular.e, scale);

  // 2 * 9 / sqrt(2) as two; as three each has volume sqrt(2)/18 and squared areas 2 * 2/9 + 2 *
  // 3/16.
  EXPECT_NEAR(regular.energy_of_two(), 12.7279, 1e-4);
  EXPECT_NEAR(regular.energy_of_three(), 31.2894, 1e-4);
  // The rim's dihedral angle is twice acos(1/3), its cotangent -7 / (4 sqrt(2)); three rim edges of
  // length 1, a sixth each.
  EXPECT_NEAR(weight, -7 / (8 * std::sqrt(2)), 1e-12);
}

TEST(FlipWeight, TwoFlatTetsBecomeThree) {
  const bipyramid flat(0.2);
  double scale = 0;

  const double weight = flip_weight(flat.rim, flat.d, flat.e, scale);

  EXPECT_GT(weight, 0);
  EXPECT_LT(flat.energy_of_three(), flat.energy_of_two());
}

TEST(FlipWeight, GivesTheGainOfTheFlip) {
  for (const double height : {0.1, 0.25, 0.3, 0.8, 2.0}) {
    const bipyramid pair(height);
    double scale = 0;

    const double weight = flip_weight(pair.rim, pair.d, pair.e, scale);

    // The affine dependency is (1/3, 1/3, 1/3, -1/2, -1/2): |v|^2 / (v_d v_e) = 10/3.
    EXPECT_NEAR(pair.energy_of_two() - pair.energy_of_three(), 30 * weight, 1e-10);
  }
}

/// The star of the middle of a 2 x 2 x 2 box, out of its place.
vertex_star box_star() {
  const auto mesh = test::box_mesh({2, 2, 2}, {1, 1, 1});
  vertex_star star;
  for (tet_id t = 0; t < mesh->tet_slots(); ++t)
    for (int i = 0; i < 4; ++i)
      if (mesh->tet_at(t).v[i] == 13)
        star.add(mesh->corners(t), i);
  return star;
}

TEST(StarEnergy, IsTheSumOverTheTets) {
  const auto star = box_star();

  // All tets of Kuhn's grid are alike.
  const double one = harmonic_energy({vec3{}, {0.5, 0, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 0.5}});

  EXPECT_EQ(star.faces.size(), 24u);
  EXPECT_NEAR(star_energy(star, {0.5, 0.5, 0.5}), 24 * one, 1e-12);
}

TEST(StarEnergy, DerivativesAgreeWithDifferences) {
  const auto star = box_star();
  const vec3 x{0.55, 0.42, 0.57};
  constexpr double h = 1e-6;

  const vec3 gradient = star_gradient(star, x);
  const auto hessian = star_hessian(star, x).m;

  const std::array<vec3, 3> axes{{{h, 0, 0}, {0, h, 0}, {0, 0, h}}};
  const std::array<double, 3> g{gradient.x, gradient.y, gradient.z};
  const std::array<vec3, 3> rows{{{hessian[0], hessian[3], hessian[5]},
                                  {hessian[3], hessian[1], hessian[4]},
                                  {hessian[5], hessian[4], hessian[2]}}};
  for (int i = 0; i < 3; ++i) {
    const double slope =
      (star_energy(star, x + axes[i]) - star_energy(star, x - axes[i])) / (2 * h);
    EXPECT_NEAR(slope, g[i], 1e-5 * norm(gradient));
    const vec3 bend =
      (star_gradient(star, x + axes[i]) - star_gradient(star, x - axes[i])) / (2 * h);
    EXPECT_LT(norm(bend - rows[i]), 1e-5 * norm(rows[i]));
  }
}

TEST(StarEnergy, NewtonComesToTheMiddleOfASymmetricalStarFromAnywhere) {
  vertex_star star;
  // The eight octants of an octahedron.
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0})
      for (const double sz : {1.0, -1.0}) {
        std::array<vec3, 4> p{vec3{}, {sx, 0, 0}, {0, sy, 0}, {0, 0, sz}};
        if (signed_volume(p) < 0)
          std::swap(p[1], p[2]);
        star.add(p, 0);
      }
  for (const vec3 start : {vec3{0.3, 0.3, 0.3}, vec3{0.9, 0, 0.05}, vec3{-0.1, 0.6, -0.2}})
    EXPECT_LT(norm(star_minimum(star, start, 50)), 1e-8);
}

TEST(StarEnergy, TheLongestStepEndsWhereATetIsFlat) {
  vertex_star star;
  star.add({vec3{0, 0, 1}, vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{0, 1, 0}}, 0);
  star.add({vec3{0, 0, 1}, vec3{0, 0, 0}, vec3{0, 1, 0}, vec3{1, 0, 0}}, 0);
  star.faces.resize(1);
  const double sign = star_energy(star, {0, 0, 1}) < 1e300 ? 1 : -1;

  EXPECT_NEAR(longest_step(star, {0, 0, sign}, {0, 0, -0.5 * sign}), 2, 1e-15);
  EXPECT_TRUE(std::isinf(longest_step(star, {0, 0, sign}, {0, 0, sign})));
  EXPECT_TRUE(std::isinf(star_energy(star, {0, 0, -sign})));
}

TEST(StarEnergy, ASystemThatIsNotPositiveDefiniteHasNoSolution) {
  EXPECT_FALSE(solve({{1, -1, 1, 0, 0, 0}}, {1, 1, 1}).has_value());
  const auto x = solve({{2, 3, 4, 1, 0.5, -1}}, {2, 4.5, 3.5});
  ASSERT_TRUE(x.has_value());
  EXPECT_NEAR(2 * x->x + x->y - x->z, 2, 1e-14);
  EXPECT_NEAR(x->x + 3 * x->y + 0.5 * x->z, 4.5, 1e-14);
  EXPECT_NEAR(-x->x + 0.5 * x->y + 4 * x->z, 3.5, 1e-14);
}

}  // namespace
}  // namespace tedit
