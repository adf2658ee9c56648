// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/hierarchy.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "fem/multilevel/lanczos.hpp"
#include "fem/multilevel/node_smoother.hpp"
#include "fem/multilevel/quadratic_level.hpp"
#include "fem/multilevel/rigid_levels.hpp"
#include "fem/native/backend.hpp"
#include "fem/native/cycle.hpp"
#include "fem/solver.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

load_case bar(double poisson = 0.3) {
  load_case loads;
  loads.materials = {{"steel", 210e9, poisson, 7850, 0, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{{0, 0, -1000}}}};
  return loads;
}

problem bar_problem(std::array<int, 3> cells, vec3 size, int order = 1) {
  return *make_problem(*test::box_mesh(cells, size), bar(), order);
}

solution solved(const problem& p, const native_settings& settings = {}) {
  solve_settings s;
  s.tolerance = 1e-8;
  auto result = solve(p, *make_native_backend(settings), s, {});
  EXPECT_TRUE(result.has_value()) << (result ? "" : render(result.error()));
  return result.value_or(solution{});
}

/// One aggregate whose matrix has `value` in the corner of a unit matrix.
rigid_level lone_aggregate(float value) {
  rigid_level level;
  level.rows = row_places(std::vector<std::uint32_t>{1});
  level.column = {0};
  rigid_level::block6 block{};
  for (std::size_t i = 0; i < 36; i += 7)
    block[i] = 1;
  block[0] = value;
  level.block.assign(1, block);
  return level;
}

TEST(CoarsestFactor, IsRefusedWhereThereIsNoneAndNeverUsed) {
  for (const float bad : {-1.0F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    const auto refused = factor(lone_aggregate(bad));
    ASSERT_FALSE(refused.has_value()) << bad;
    EXPECT_EQ(refused.error().code, ec::not_converged);
    EXPECT_NE(refused.error().message.find("coarsest level (6 unknowns)"), std::string::npos);
  }
  const auto sound = factor(lone_aggregate(4));
  ASSERT_TRUE(sound.has_value());
  std::array<float, 6> x{1, 0, 0, 0, 0, 2};
  (*sound)->solve(x, x);
  EXPECT_FLOAT_EQ(x[0], 0.25F);
  EXPECT_FLOAT_EQ(x[5], 2);
}

TEST(Lanczos, FindsTheLargestEigenvalueOfADiagonal) {
  const std::size_t n = 500;
  const auto a = [&](const float* x, float* y) {
    for (std::size_t i = 0; i < n; ++i)
      y[i] = (1 + 3.0F * static_cast<float>(i) / static_cast<float>(n - 1)) * x[i];
  };
  const auto b = [&](const float* x, float* y) { std::copy_n(x, n, y); };

  const float lambda = largest_ritz_value(n, 0, 12, a, b);

  EXPECT_LE(lambda, 4.0001F);  // From below.
  EXPECT_GE(lambda, 3.8F);
}

/// The blocks come from a closed formula; the operator goes from strains to forces.
TEST(QuadraticSmoother, InvertsTheBlocksOfTheOperator) {
  const auto p = bar_problem({3, 2, 2}, {2, 1, 1}, 2);
  const auto smoother = make_quadratic_smoother(p, p.filter, {});
  const element_operator k(p);
  std::vector<double> unit(p.dofs(), 0);
  std::vector<double> column(p.dofs());
  std::size_t held = 0;
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const bool is_free = p.filter[n] == std::array<double, 6>{1, 0, 0, 1, 0, 1};
    held += is_free ? 0 : 1;
    const auto& b = smoother.inverse[n];
    const std::array<std::array<float, 3>, 3> inverse{
      {{b[0], b[1], b[2]}, {b[1], b[3], b[4]}, {b[2], b[4], b[5]}}};
    for (std::size_t j = 0; j < 3; ++j) {
      unit[3 * n + j] = 1;
      k.apply(unit, column);
      unit[3 * n + j] = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        double product = 0;
        for (std::size_t c = 0; c < 3; ++c)
          product += static_cast<double>(inverse[i][c]) * column[3 * n + c];
        EXPECT_NEAR(product, is_free && i == j ? 1 : 0, 1e-5) << "node " << n;
      }
    }
  }
  EXPECT_GT(held, 0u);
}

/// The largest eigenvalue is looked for where something changed, and never falls.
TEST(QuadraticSmoother, FindsTheEigenvaluesOfChangedElements) {
  const auto p = bar_problem({6, 3, 3}, {2, 1, 1}, 2);
  const incidence corners(p, 4);
  const multilevel_settings settings;
  std::vector<std::uint32_t> cluster_of;
  auto smoother = make_quadratic_smoother(p, p.filter, {});
  const auto found_at = [&](const std::vector<std::uint32_t>& nodes, float before) {
    smoother.lambda = before;
    update_quadratic_smoother(p, corners, p.filter, nodes, settings, cluster_of, smoother);
    return smoother.lambda;
  };
  std::vector<std::uint32_t> all(p.node_count());
  std::iota(all.begin(), all.end(), 0u);
  const element_operator k(p);
  std::vector<double> product(p.dofs());
  const float whole =
    settings.lambda_safety * largest_ritz_value(
                               p.dofs(), 1, 30,
                               [&](const float* x, float* y) {
                                 k.apply(std::vector<double>(x, x + p.dofs()), product);
                                 std::ranges::copy(product, y);
                               },
                               [&](const float* x, float* y) { apply_inverse(smoother, 1, x, y); });

  EXPECT_NEAR(found_at(all, 0), whole, 0.05F * whole);
  const float near_corner = found_at({20}, 0);
  EXPECT_GT(near_corner, 0.4F * whole);
  EXPECT_LE(near_corner, whole);
  EXPECT_EQ(found_at({20}, 10), 10);
}

TEST(Chebyshev, StepsAreThoseOfTheFourthKind) {
  // Lottes 2023: d_2 = 1/5 d_1 + 12/(5 lambda) r.
  const auto w = chebyshev_step(2, 2);
  EXPECT_FLOAT_EQ(w.before, 0.2F);
  EXPECT_FLOAT_EQ(w.fresh, 1.2F);
  EXPECT_FLOAT_EQ(chebyshev_start(2), 2.0F / 3);
}

double dot_of(const std::vector<float>& a, const std::vector<float>& b) {
  return native::dots_of<one_case>(a, b)[0];
}

TEST(Cycle, IsSymmetricAndPositive) {
  const auto p = bar_problem({24, 8, 8}, {4, 1, 1});
  const incidence corners(p);
  const auto k = assemble_blocks(p, corners);
  multilevel_settings small{.rounded = true};
  small.coarsest = 8;  // So that all kinds of levels take part.
  const auto h = *build_hierarchy(p, k, p.filter, small, {});
  ASSERT_GE(h.levels.size(), 3u);
  native::multilevel_cycle cycle(k, h, {});
  const std::size_t n = padded3(p.node_count());
  std::vector<float> x(n, 0);
  std::vector<float> y(n, 0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    x[i] = static_cast<float>(std::sin(0.37 * static_cast<double>(i)));
    y[i] = static_cast<float>(std::cos(0.11 * static_cast<double>(i)));
  }
  std::vector<float> bx(n, 0);
  std::vector<float> by(n, 0);

  cycle.apply(x.data(), bx.data());
  cycle.apply(y.data(), by.data());

  EXPECT_NEAR(dot_of(x, by), dot_of(y, bx), 1e-5 * std::sqrt(dot_of(x, bx) * dot_of(y, by)));
  EXPECT_GT(dot_of(x, bx), 0);
  EXPECT_GT(dot_of(y, by), 0);
}

TEST(Multilevel, IterationsHardlyGrowWithSize) {
  const auto few = solved(bar_problem({16, 4, 4}, {4, 1, 1}));
  const auto many = solved(bar_problem({64, 16, 16}, {4, 1, 1}));

  EXPECT_LE(many.iterations, 1.5 * few.iterations) << few.iterations;
  EXPECT_LE(many.iterations, 45);
}

TEST(Multilevel, SmallGuessesOfLambdaAreCaught) {
  const auto p = bar_problem({24, 6, 6}, {4, 1, 1});
  native_settings wrong;
  // A third of the largest eigenvalue: the smoother amplifies, the cycle is not positive definite.
  wrong.multilevel.lambda_safety = 0.33F;

  const auto right = solved(p);
  const auto caught = solved(p, wrong);

  EXPECT_TRUE(caught.converged);
  EXPECT_NEAR(caught.compliance_j, right.compliance_j, 1e-7 * right.compliance_j);
}

TEST(Multilevel, StiffnessJumpsAndNearlyIncompressibleMaterialsConverge) {
  const auto mesh = test::box_mesh({32, 8, 8}, {4, 1, 1});
  for (const int order : {1, 2}) {
    EXPECT_LE(solved(*make_problem(*mesh, bar(0.499), order)).iterations, order == 1 ? 300 : 600);
    auto p = *make_problem(*mesh, bar(0.45), order);
    p.constants.push_back({1e-4 * p.constants[0].lambda, 1e-4 * p.constants[0].mu});
    p.densities.push_back(p.densities[0]);
    p.yield_strengths.push_back(0);
    for (std::size_t e = 0; e < p.element_count(); ++e)
      if (p.nodes[p.element_nodes[p.nodes_per_element * e]].y < 0.5)
        p.element_materials[e] = 1;
    EXPECT_LE(solved(p).iterations, order == 1 ? 60 : 80);
  }
}

TEST(Multilevel, SliverTetsDoNotStall) {
  // Some inner nodes almost on top of a neighbour. Quadratic tets suffer from milder slivers: at
  // 0.08 of an edge, with a condition of 8, they take 41 iterations without clusters.
  const auto sliver_bar = [](double shift) {
    return test::box_mesh({16, 6, 6}, {16, 6, 6}, [shift](vec3 p) {
      const bool inside = p.x > 0 && p.x < 16 && p.y > 0 && p.y < 6 && p.z > 0 && p.z < 5;
      const bool chosen = static_cast<int>(p.x + 3 * p.y + 7 * p.z) % 11 == 0;
      return inside && chosen ? p + vec3{0, 0, shift} : p;
    });
  };
  native_settings plain;
  plain.multilevel.sliver_condition = 0;
  plain.corner_multilevel.sliver_condition = 0;
  for (const auto& [order, shift, most] :
       {std::tuple(1, 0.995, 60), std::tuple(2, 0.995, 30), std::tuple(2, 0.92, 30)}) {
    const auto p = *make_problem(*sliver_bar(shift), bar(), order);
    const int clustered = solved(p).iterations;
    EXPECT_LE(clustered, most) << order << ' ' << shift;
    EXPECT_GT(solved(p, plain).iterations, clustered) << order << ' ' << shift;
  }
}

TEST(Multilevel, SheetsHeldAcrossTheirThicknessHaveNoLostMotions) {
  // Plane strain: every node is held in z, so that whole motions of each aggregate are none.
  auto loads = bar();
  loads.constraints.push_back({{5, 6}, prescribed_displacement{{}, {}, 0.0}});
  loads.loads = {{{2}, force{{0, -1000, 0}}}};
  for (const int order : {1, 2}) {
    const auto p = *make_problem(*test::box_mesh({40, 10, 1}, {4, 1, 0.1}), loads, order);
    const auto result = solved(p);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.iterations, 60);
    for (std::size_t n = 0; n < p.corner_count; ++n)
      EXPECT_EQ(result.displacement[3 * n + 2], 0);
  }
}

TEST(Multilevel, ProblemsWithHardlyAnyFreeNodeWork) {
  auto loads = bar();
  loads.constraints = {{{1, 3, 4, 5, 6}, fixed{}}};
  for (const int order : {1, 2}) {
    const auto p = *make_problem(*test::box_mesh({2, 2, 2}, {1, 1, 1}), loads, order);
    EXPECT_TRUE(solved(p).converged);
  }
}

}  // namespace
}  // namespace tedit::fem
