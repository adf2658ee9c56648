// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/element_operator.hpp"
#include "fem/quadratic.hpp"
#include "fem/recovery.hpp"
#include "tests/fem/quadrature.hpp"

namespace tedit::fem {
namespace {

using test::box_mesh;
using test::patch_field;
using test::simple_case;

vec3 total(std::span<const double> x) {
  vec3 sum;
  for (std::size_t i = 0; i < x.size(); i += 3)
    sum += vec3{x[i], x[i + 1], x[i + 2]};
  return sum;
}

double largest_entry(std::span<const double> x) {
  double result = 0;
  for (const double value : x)
    result = std::max(result, std::abs(value));
  return result;
}

problem box_problem(int order, std::array<int, 3> cells, vec3 size, const load_case& loads) {
  auto p = make_problem(
    *box_mesh(cells, size, [&](vec3 x) { return test::shaken_inside(x, size); }), loads, order);
  EXPECT_TRUE(p.has_value()) << (p ? "" : render(p.error()));
  return p.value_or(problem{});
}

bool inside(vec3 x, vec3 size) {
  return x.x > 1e-9 && x.x < size.x - 1e-9 && x.y > 1e-9 && x.y < size.y - 1e-9 && x.z > 1e-9 &&
         x.z < size.z - 1e-9;
}

// -- nodes ---------------------------------------------------------------------------

TEST(QuadraticProblem, CornersStayAndMidNodesFollowByTheirEnds) {
  const auto linear = box_problem(1, {3, 2, 2}, {1, 1, 1}, simple_case(1e6, 0.3));
  const auto p = box_problem(2, {3, 2, 2}, {1, 1, 1}, simple_case(1e6, 0.3));

  ASSERT_EQ(p.corner_count, linear.node_count());
  EXPECT_EQ(p.nodes_per_element, 10);
  EXPECT_EQ(p.node_vertices, linear.node_vertices);
  EXPECT_EQ(p.element_tets, linear.element_tets);
  EXPECT_EQ(p.node_count(), p.corner_count + p.edge_ends.size());
  EXPECT_TRUE(std::ranges::is_sorted(p.edge_ends));
  EXPECT_EQ(std::ranges::adjacent_find(p.edge_ends), p.edge_ends.end());
  for (std::size_t e = 0; e < p.element_count(); ++e)
    for (int i = 0; i < 6; ++i) {
      const auto* n = &p.element_nodes[10 * e];
      const auto [a, b] = ends_of_mid_node[i];
      const auto& ends = p.edge_ends[n[4 + i] - p.corner_count];
      EXPECT_EQ(ends[0], std::min(n[a], n[b]));
      EXPECT_EQ(ends[1], std::max(n[a], n[b]));
      EXPECT_EQ(p.nodes[n[4 + i]], 0.5 * (p.nodes[n[a]] + p.nodes[n[b]]));
      EXPECT_EQ(mid_node_of[a][b], 4 + i);
    }
}

TEST(QuadraticProblem, ElementsFollowTheirSmallestNode) {
  const auto mesh = box_mesh({3, 3, 3}, {1, 1, 1});
  const auto p = *make_problem(*mesh, simple_case(1e6, 0.3));

  std::uint32_t last = 0;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const auto nodes = std::span(p.element_nodes).subspan(4 * e, 4);
    EXPECT_GE(std::ranges::min(nodes), last);
    last = std::ranges::min(nodes);
    for (int a = 0; a < 4; ++a)
      EXPECT_EQ(p.node_vertices[nodes[a]], mesh->tet_at(p.element_tets[e]).v[a]);
  }
}

TEST(QuadraticProblem, AnotherOrderIsRefused) {
  const auto p = make_problem(*box_mesh({1, 1, 1}, {1, 1, 1}), simple_case(1e6, 0.3), 3);

  ASSERT_FALSE(p.has_value());
  EXPECT_EQ(p.error().code, ec::invalid_argument);
}

// -- loads and constraints -------------------------------------------------------------

TEST(QuadraticLoads, SurfaceLoadsGoToMidNodesAndKeepTheirTotal) {
  auto loads = simple_case(1e6, 0.3);
  loads.loads = {{{2}, force{{1, 2, 3}}}, {{4}, pressure{10}}};
  const auto p = box_problem(2, {2, 2, 2}, {2, 1, 1}, loads);

  EXPECT_NEAR(norm(total(p.loads) - vec3{1, 2 - 20, 3}), 0, 1e-12);
  for (std::size_t i = 0; i < 3 * p.corner_count; ++i)
    EXPECT_EQ(p.loads[i], 0);
}

TEST(QuadraticLoads, GravityIsTheWeightAndPullsCornersUp) {
  auto loads = simple_case(1e6, 0.3);
  loads.loads = {{{}, gravity{{0, 0, -10}}}};
  const auto p = box_problem(2, {2, 2, 2}, {2, 1, 1}, loads);

  EXPECT_NEAR(total(p.loads).z, -2 * 1000 * 10, 1e-9);
  for (std::size_t n = 0; n < p.node_count(); ++n)
    EXPECT_EQ(p.loads[3 * n + 2] > 0, n < p.corner_count);
}

TEST(QuadraticConstraints, HoldTheMidNodesOfTheirSurfaces) {
  auto loads = simple_case(1e6, 0.3);
  loads.constraints = {
    {{1}, fixed{}}, {{4}, roller{}}, {{2}, prescribed_displacement{1e-3, {}, {}}}};
  const auto p = box_problem(2, {2, 2, 2}, {2, 1, 1}, loads);

  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto& x = p.nodes[n];
    const auto& s = p.filter[n];
    EXPECT_NEAR(s[0], x.x == 0 || x.x == 2 ? 0 : 1, 1e-12);
    EXPECT_NEAR(s[3], x.x == 0 || x.y == 1 ? 0 : 1, 1e-12);
    EXPECT_NEAR(s[5], x.x == 0 ? 0 : 1, 1e-12);
    EXPECT_NEAR(p.prescribed[3 * n], x.x == 2 ? 1e-3 : 0, 1e-15);
  }
}

TEST(QuadraticConstraints, ASlidingPartIsNamed) {
  auto loads = simple_case(1e6, 0.3);
  loads.constraints = {{{3}, roller{}}, {{5}, roller{}}};

  const auto p = make_problem(*box_mesh({2, 1, 1}, {2, 1, 1}), loads, 2);

  ASSERT_FALSE(p.has_value());
  EXPECT_EQ(p.error().code, ec::under_constrained);
  EXPECT_THAT(p.error().message, ::testing::HasSubstr("translation along"));
}

// -- the operator ------------------------------------------------------------------------

class Operator : public ::testing::TestWithParam<int> {};

TEST_P(Operator, AgreesWithGaussQuadrature) {
  // More than one chunk of elements, and an odd number in the last one.
  auto p = box_problem(GetParam(), {7, 7, 8}, {1, 1, 1}, simple_case(1e6, 0.3));
  p.element_tets.pop_back();
  p.element_materials.pop_back();
  p.element_nodes.resize(p.element_nodes.size() - p.nodes_per_element);
  p.element_materials[7] = 1;
  p.constants.push_back({3e6, 1e5});
  std::vector<double> u(p.dofs());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::sin(1.0 + 3.7 * static_cast<double>(i));
  test::vector expected = test::vector::Zero(p.dofs());
  const std::size_t per = p.nodes_per_element;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    test::vector own(3 * per);
    for (std::size_t i = 0; i < 3 * per; ++i)
      own[i] = u[3 * p.element_nodes[per * e + i / 3] + i % 3];
    const test::vector f = test::element_matrix(p, e) * own;
    for (std::size_t i = 0; i < 3 * per; ++i)
      expected[3 * p.element_nodes[per * e + i / 3] + i % 3] += f[i];
  }

  std::vector<double> result(p.dofs(), 7);
  std::vector<double> again(p.dofs(), 8);
  const element_operator k(p);
  k.apply(u, result);
  element_operator(p).apply(u, again);

  const double scale = expected.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < result.size(); ++i)
    ASSERT_NEAR(result[i], expected[i], 1e-13 * scale) << i;
  EXPECT_EQ(result, again);
}

TEST_P(Operator, ALinearFieldIsInBalanceAndExact) {
  const auto p = box_problem(GetParam(), {3, 3, 3}, {1, 1, 1}, simple_case(1e6, 0.25));
  const auto u = test::at_nodes(p, patch_field);
  std::vector<double> force(p.dofs());

  element_operator(p).apply(u, force);

  const double scale = largest_entry(force);
  for (std::size_t n = 0; n < p.node_count(); ++n)
    if (inside(p.nodes[n], {1, 1, 1})) {
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(force[3 * n + i], 0, 1e-12 * scale);
    }
  for (std::size_t e = 0; e < p.element_count(); ++e)
    for (const auto& stress : corner_stress(p, u, e))
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(stress[i], i < 3 ? 2000 : 400, 2000 * 1e-12);
}

TEST_P(Operator, ThePatchTestSolvedDirectlyIsExact) {
  auto loads = simple_case(1e6, 0.25);
  loads.constraints = {{{1, 2, 3, 4, 5, 6}, fixed{}}};
  auto p = box_problem(GetParam(), {2, 3, 2}, {1, 1, 1}, loads);
  std::ranges::fill(p.loads, 0.0);
  const auto exact = test::at_nodes(p, patch_field);
  for (std::size_t n = 0; n < p.node_count(); ++n)
    if (p.filter[n][0] == 0)
      std::copy_n(&exact[3 * n], 3, &p.prescribed[3 * n]);

  const auto u = test::solve_directly(p);

  for (std::size_t i = 0; i < u.size(); ++i)
    EXPECT_NEAR(u[i], exact[i], 2e-3 * 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Orders, Operator, ::testing::Values(1, 2));

TEST(QuadraticOperator, PureBendingIsExact) {
  const vec3 size{3, 1, 1};
  const double e = 200e9;
  const double nu = 0.3;
  const double k = 1e-3;
  const auto p = box_problem(2, {4, 3, 3}, size, simple_case(e, nu));
  const auto u = test::at_nodes(p, [&](vec3 x) {
    return k * vec3{x.x * x.y, -0.5 * (x.x * x.x + nu * (x.y * x.y - x.z * x.z)), -nu * x.y * x.z};
  });
  std::vector<double> force(p.dofs());

  element_operator(p).apply(u, force);

  const double scale = largest_entry(force);
  double pull = 0;
  double moment = 0;
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto& x = p.nodes[n];
    if (x.x > 1e-9 && x.x < size.x - 1e-9) {  // Inside and on the sides, which are free.
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(force[3 * n + i], 0, 1e-10 * scale);
    }
    if (x.x >= size.x - 1e-9) {
      pull += force[3 * n];
      moment += x.y * force[3 * n];
    }
  }
  EXPECT_NEAR(pull, e * k / 2, 1e-10 * e * k);  // Integrals of E k y and E k y^2 over the end.
  EXPECT_NEAR(moment, e * k / 3, 1e-10 * e * k);
  for (std::size_t el = 0; el < p.element_count(); ++el)
    for (std::size_t c = 0; c < 4; ++c)
      for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(corner_stress(p, u, el)[c][i],
                    i == 0 ? e * k * p.nodes[p.element_nodes[10 * el + c]].y : 0, 1e-11 * e * k);
}

}  // namespace
}  // namespace tedit::fem
