// SPDX-License-Identifier: AGPL-3.0-or-later
// The outer iteration, with corrections that are made up.
#include "fem/refinement.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "fem/element_operator.hpp"

namespace tedit::fem {
namespace {

/// A tet of legs 1 m and both of Lame's constants 1 Pa, held at its base; its top is pressed by
/// 0.5 N. Of a sixth of a cubic metre, and where the top's shape function is z, its stiffness along
/// z is (1 + 2) / 6 = 0.5 N/m: the top goes 1 m down.
problem pressed_tet() {
  problem p;
  p.corner_count = 4;
  p.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  p.node_vertices = {0, 1, 2, 3};
  p.element_nodes = {0, 1, 2, 3};
  p.element_tets = {0};
  p.element_materials = {0};
  p.constants = {{1, 1}};
  p.densities = {7850};
  p.yield_strengths = {0};
  p.loads.assign(12, 0);
  p.loads[11] = -0.5;
  p.prescribed.assign(12, 0);
  p.filter.assign(4, {0, 0, 0, 0, 0, 0});
  p.filter[3] = {1, 0, 0, 1, 0, 1};
  return p;
}

TEST(Refinement, ACorrectionThatGainsNothingIsNotWorthItsWhileAndOneThatDoesIs) {
  const auto p = pressed_tet();
  const element_operator k(p);
  const solve_settings settings;
  solution out;
  refinement one({"", p.loads, p.filter, p.prescribed}, k, settings, out);

  EXPECT_EQ(one.next(false).residual[11], -1) << "of the residual's norm";
  EXPECT_FALSE(one.take({})) << "nothing was written";
  EXPECT_EQ(out.true_relative_residual, 1);

  one.next(false).correction[11] = -2;
  EXPECT_TRUE(one.take({}));
  EXPECT_NEAR(out.displacement[11], -1, 1e-12);
  EXPECT_NEAR(out.true_relative_residual, 0, 1e-12);
  EXPECT_TRUE(one.done());
}

}  // namespace
}  // namespace tedit::fem
