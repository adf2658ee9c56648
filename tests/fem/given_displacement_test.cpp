// SPDX-License-Identifier: AGPL-3.0-or-later
// What follows from a displacement that somebody else found, and what is no solution.
#include "fem/given_displacement.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/fem/quadrature.hpp"

namespace tedit::fem {
namespace {

using ::testing::HasSubstr;

/// A bar of 3 x 1 x 1 m under 1 MPa along x, E = 200 GPa, nu = 0.3, on rollers.
problem pulled_bar(int order) {
  auto loads = test::simple_case(200e9, 0.3);
  loads.constraints = {{{1}, roller{}}, {{3}, roller{}}, {{5}, roller{}}};
  loads.loads = {{{2}, traction{{1e6, 0, 0}}}};
  return make_problem(*test::box_mesh({3, 2, 2}, {3, 1, 1}), loads, order).value();
}

/// Exactly: strain 5e-6 along, 1.5e-6 across; the rollers are at x, y and z = 0.
std::vector<double> exact(const problem& p) {
  std::vector<double> u;
  for (const auto& at : p.nodes)
    u.insert(u.end(), {5e-6 * at.x, -1.5e-6 * at.y, -1.5e-6 * at.z});
  return u;
}

expected<solution> judged(const problem& p, std::vector<double> u) {
  return solution_of(p, element_operator(p), std::move(u), "paper");
}

class GivenDisplacement : public ::testing::TestWithParam<int> {};

TEST_P(GivenDisplacement, AnExactOneIsASolutionWithAllThatFollows) {
  const auto p = pulled_bar(GetParam());
  const auto s = judged(p, exact(p));
  ASSERT_TRUE(s.has_value()) << render(s.error());
  EXPECT_LT(s->true_relative_residual, 1e-9);
  EXPECT_EQ(s->preview(), GetParam() == 1);
  EXPECT_EQ(s->device, "paper");
  EXPECT_NEAR(s->max_von_mises_pa, 1e6, 1e-3);
  EXPECT_NEAR(s->max_displacement_m, std::sqrt(15e-6 * 15e-6 + 2 * 1.5e-6 * 1.5e-6), 1e-15);
  EXPECT_NEAR(norm(s->reaction_n - vec3{-1e6, 0, 0}), 0, 1e-3);
}

TEST_P(GivenDisplacement, SevenDigitsAreEnough) {
  const auto p = pulled_bar(GetParam());
  auto u = exact(p);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] *= 1 + (i % 2 == 0 ? 5e-7 : -5e-7);
  const auto s = judged(p, u);
  ASSERT_TRUE(s.has_value()) << render(s.error());
  EXPECT_GT(s->true_relative_residual, 1e-9);
  EXPECT_LT(s->true_relative_residual, 1e-4);
}

TEST_P(GivenDisplacement, WhatIsNoSolutionIsNoneAndSaysHowFarItIsOff) {
  const auto p = pulled_bar(GetParam());
  const auto nothing = judged(p, std::vector<double>(p.dofs()));
  ASSERT_FALSE(nothing.has_value());
  EXPECT_EQ(nothing.error().code, ec::not_converged);
  EXPECT_THAT(
    nothing.error().message,
    HasSubstr("the solver paper gave is no solution: it leaves a relative residual of 1"));

  // A rigid motion costs no energy, but the rollers do not move.
  auto moved = exact(p);
  for (auto& x : moved)
    x += 1e-5;
  EXPECT_EQ(judged(p, moved).error().code, ec::not_converged);

  // 1.01 u: d.Sf = 1.01 f.u, d.Kd = 1.0201 f.u, so they are 0.0101 / 1.0201 apart.
  auto larger = exact(p);
  for (auto& x : larger)
    x *= 1.01;
  const auto scaled = judged(p, larger);
  ASSERT_FALSE(scaled.has_value());
  EXPECT_THAT(scaled.error().message,
              HasSubstr("a relative residual of 0.01, and loads and stiffness do different work "
                        "(0.0099 apart)"));
}

TEST_P(GivenDisplacement, NumbersThatAreMissingOrNoneAreRefused) {
  const auto p = pulled_bar(GetParam());
  auto short_one = exact(p);
  short_one.pop_back();
  EXPECT_EQ(judged(p, short_one).error().code, ec::bad_input);
  auto bad = exact(p);
  bad[7] = std::nan("");
  EXPECT_EQ(judged(p, bad).error().code, ec::bad_input);
  EXPECT_THAT(judged(p, bad).error().message, HasSubstr("a finite displacement for each of"));
}

INSTANTIATE_TEST_SUITE_P(Orders, GivenDisplacement, ::testing::Values(1, 2));

}  // namespace
}  // namespace tedit::fem
