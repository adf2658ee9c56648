// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/problem_update.hpp"

#include <set>

#include <gtest/gtest.h>

#include "fem/block_matrix.hpp"
#include "fem/quadratic.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

load_case cantilever() {
  load_case loads;
  loads.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{{0, 0, -1000}}}};
  return loads;
}

using point = std::array<double, 3>;
using element_points = std::vector<point>;

/// Every element by its tet: where its nodes are, in order.
std::map<tet_id, element_points> elements_of(const problem& p) {
  std::map<tet_id, element_points> result;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    auto& points = result[p.element_tets[e]];
    for (int a = 0; a < p.nodes_per_element; ++a) {
      const auto x = p.nodes[p.element_nodes[p.nodes_per_element * e + a]];
      points.push_back({x.x, x.y, x.z});
    }
  }
  return result;
}

std::vector<std::uint32_t> nodes_without_element(const problem& p) {
  std::vector<std::uint8_t> used(p.node_count(), 0);
  for (const auto n : p.element_nodes)
    used[n] = 1;
  std::vector<std::uint32_t> result;
  for (std::uint32_t n = 0; n < used.size(); ++n)
    if (used[n] == 0)
      result.push_back(n);
  return result;
}

void expect_same_rows(const block_matrix& a, const block_matrix& b) {
  ASSERT_EQ(a.rows(), b.rows());
  for (std::size_t n = 0; n < a.rows(); ++n) {
    const auto left = a.places.of(n, a.column);
    const auto right = b.places.of(n, b.column);
    ASSERT_TRUE(std::ranges::equal(left, right)) << "row " << n;
    for (std::size_t s = 0; s < left.size(); ++s)
      ASSERT_EQ(a.block(a.begin(n) + s), b.block(b.begin(n) + s)) << "row " << n;
  }
}

/// A problem that follows its mesh from edit to edit, and its matrix.
class ProblemUpdate : public testing::TestWithParam<int> {
protected:
  void follow(const version_ptr& next) {
    ASSERT_TRUE(next);
    auto applied = updater_.apply(*mesh_, *next, cantilever(), p_);
    ASSERT_TRUE(applied.has_value()) << render(applied.error());
    ASSERT_TRUE(applied->has_value()) << "was not taken as a small change";
    ASSERT_TRUE(set_conditions(*next, cantilever(), p_).has_value());
    mesh_ = next;
    change_ = **applied;
    update_blocks(p_, updater_.corners(), change_.nodes, k_);
    expect_like_new();
  }

  void expect_like_new() {
    const auto fresh = *make_problem(*mesh_, cantilever(), GetParam());
    EXPECT_EQ(elements_of(p_), elements_of(fresh));
    EXPECT_EQ(p_.unknowns(), fresh.unknowns());
    EXPECT_EQ(nodes_without_element(p_), p_.unused);
    const incidence corners(p_, 4);
    for (std::size_t n = 0; n < p_.corner_count; ++n)
      ASSERT_TRUE(std::ranges::equal(corners.of_node(n), updater_.corners().of_node(n)));
    expect_same_rows(k_, assemble_blocks(p_, corners));
    vec3 load;
    for (std::size_t n = 0; n < p_.node_count(); ++n)
      load.z += p_.loads[3 * n + 2];
    EXPECT_NEAR(load.z, -1000, 1e-9);
    for (const auto n : p_.unused)
      EXPECT_EQ(p_.filter[n][0] + p_.filter[n][3] + p_.filter[n][5], 0);
  }

  version_ptr mesh_ = test::box_mesh({16, 6, 6}, {4, 1.5, 1.5});
  problem p_ = *make_problem(*mesh_, cantilever(), GetParam(), 20);
  problem_updater updater_{p_};
  block_matrix k_ = assemble_blocks(p_, updater_.corners());
  problem_change change_;
};

INSTANTIATE_TEST_SUITE_P(Orders, ProblemUpdate, testing::Values(1, 2));

TEST_P(ProblemUpdate, SpareCornersChangeNothing) {
  const auto plain = *make_problem(*mesh_, cantilever(), GetParam());
  EXPECT_EQ(p_.unused.size(), 20u);
  EXPECT_EQ(p_.unknowns(), plain.unknowns());
  EXPECT_EQ(elements_of(p_), elements_of(plain));
}

TEST_P(ProblemUpdate, ASplitTetAddsOneNodeAndThreeElements) {
  const auto before = p_.element_count();
  follow(test::split(mesh_, [](tet_id t) { return t == 100; }));
  EXPECT_EQ(p_.element_count(), before + 3);
  EXPECT_EQ(p_.unused.size(), 19u);
  // Four corners and the new one; the six old edges and the four new ones.
  EXPECT_EQ(change_.nodes.size(), GetParam() == 1 ? 5u : 15u);
  EXPECT_EQ(change_.elements.size(), 4u);
}

TEST_P(ProblemUpdate, APitTakesElementsAndNodes) {
  follow(test::dig(
    mesh_, [](vec3 x) { return x.x > 2 && x.x < 2.5 && x.z > 1.2 && x.y > .5 && x.y < 1; }, 7));
  EXPECT_GT(p_.unused.size(), 20u);
  EXPECT_LT(change_.nodes.size(), p_.node_count() / 4);
}

TEST_P(ProblemUpdate, MovedVerticesTouchTheirElementsOnly) {
  follow(test::move(mesh_, [](vec3 x) {
    return norm(x - vec3{1, .5, .5}) < 0.1 ? x + vec3{.02, 0, 0} : x;
  }));
  EXPECT_EQ(p_.unused.size(), 20u);
  EXPECT_EQ(change_.elements.size(), 24u);
}

TEST_P(ProblemUpdate, ManyEditsOneAfterTheOther) {
  for (int round = 0; round < 4; ++round) {
    const double at = 0.5 + 0.75 * round;
    follow(test::split(mesh_, [&](tet_id t) { return t % 801 == 17u * round; }));
    follow(test::dig(
      mesh_,
      [&](vec3 x) {
        return norm(x - vec3{at, .75, 1.5}) < 0.22;
      },
      7));
    follow(test::move(mesh_, [&](vec3 x) {
      return norm(x - vec3{at, .75, .75}) < 0.2 ? x + vec3{0, .01, .01} : x;
    }));
  }
}

TEST_P(ProblemUpdate, ABigChangeIsLeftToANewProblem) {
  const auto next = test::move(mesh_, [](vec3 x) { return x.x > 2 ? x + vec3{.1, 0, 0} : x; });
  const auto before = p_.element_nodes;
  const auto applied = updater_.apply(*mesh_, *next, cantilever(), p_);
  ASSERT_TRUE(applied.has_value());
  EXPECT_FALSE(applied->has_value());
  EXPECT_EQ(p_.element_nodes, before);
}

TEST_P(ProblemUpdate, ATetTurnedInsideOutIsRefused) {
  const auto next = test::move(mesh_, [](vec3 x) {
    return norm(x - vec3{1, .5, .5}) < 0.1 ? x + vec3{1, 0, 0} : x;
  });
  const auto applied = updater_.apply(*mesh_, *next, cantilever(), p_);
  ASSERT_FALSE(applied.has_value());
  EXPECT_EQ(applied.error().code, ec::inverted_tet);
}

}  // namespace
}  // namespace tedit::fem
