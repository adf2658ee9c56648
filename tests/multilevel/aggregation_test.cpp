// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/aggregation.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "fem/multilevel/slivers.hpp"

namespace tedit::fem {
namespace {

/// A strip of n x 4 nodes, numbered column by column; `weight(i)` is that of the edges between the
/// columns i and i + 1, all others are 1.
template <class Weight>
node_graph strip(std::uint32_t n, Weight&& weight) {
  constexpr std::uint32_t width = 4;
  node_graph graph;
  graph.first.push_back(0);
  const auto add = [&](std::uint32_t to, float w) {
    graph.column.push_back(to);
    graph.weight.push_back(w);
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < width; ++j) {
      if (i > 0)
        add((i - 1) * width + j, weight(i - 1));
      if (j > 0)
        add(i * width + j - 1, 1);
      if (j + 1 < width)
        add(i * width + j + 1, 1);
      if (i + 1 < n)
        add((i + 1) * width + j, weight(i));
      graph.first.push_back(static_cast<std::uint32_t>(graph.column.size()));
    }
  return graph;
}

std::map<std::uint32_t, std::set<std::uint32_t>> members(const aggregation& a) {
  std::map<std::uint32_t, std::set<std::uint32_t>> result;
  for (std::uint32_t n = 0; n < a.of.size(); ++n)
    if (a.of[n] != no_id)
      result[a.of[n]].insert(n);
  return result;
}

TEST(Mis2, CoversAllNodesWithSmallPieces) {
  const auto a =
    aggregate_mis2(strip(25, [](auto) { return 1.0F; }), std::vector<std::uint8_t>(100, 0), {});

  const auto sets = members(a);
  EXPECT_EQ(sets.size(), a.count);
  EXPECT_LE(sets.size(), 25u);
  std::size_t covered = 0;
  for (const auto& [id, nodes] : sets) {
    covered += nodes.size();
    // A root, its neighbours and theirs: at most four columns to each side.
    EXPECT_LE(*nodes.rbegin() - *nodes.begin(), 4u * 8);
  }
  EXPECT_EQ(covered, 100u);
}

TEST(Mis2, LeavesHeldNodesOut) {
  std::vector<std::uint8_t> held(20, 0);
  held[0] = held[7] = 1;

  const auto a = aggregate_mis2(strip(5, [](auto) { return 1.0F; }), held, {});

  EXPECT_EQ(a.of[0], no_id);
  EXPECT_EQ(a.of[7], no_id);
  for (const std::uint32_t n : {1u, 6u, 8u, 19u})
    EXPECT_NE(a.of[n], no_id);
}

TEST(Mis2, DoesNotReachOverWeakEdges) {
  const auto a = aggregate_mis2(strip(40, [](std::uint32_t i) { return i == 19 ? 1e-3F : 1.0F; }),
                                std::vector<std::uint8_t>(160, 0), {});

  for (const auto& [id, nodes] : members(a))
    EXPECT_TRUE(*nodes.rbegin() < 80 || *nodes.begin() >= 80) << "from " << *nodes.begin();
}

TEST(Mis2, GluesClusters) {
  std::vector<std::uint32_t> cluster(60, no_id);
  for (std::uint32_t n = 10; n < 40; ++n)
    cluster[n] = 0;

  const auto a =
    aggregate_mis2(strip(15, [](auto) { return 1.0F; }), std::vector<std::uint8_t>(60, 0), cluster);

  for (std::uint32_t n = 10; n < 40; ++n)
    EXPECT_EQ(a.of[n], a.of[10]);
}

TEST(Mis2, LoneNodesAreAggregatesOfTheirOwn) {
  node_graph graph;
  graph.first = {0, 0, 0};

  const auto a = aggregate_mis2(graph, std::vector<std::uint8_t>(2, 0), {});

  EXPECT_EQ(a.count, 2u);
  EXPECT_NE(a.of[0], a.of[1]);
}

TEST(Pairs, GroupsOfEightAlongTheStrongestEdges) {
  // Weak links after every second column of four nodes: the groups lie between them.
  const auto graph = strip(16, [](std::uint32_t i) { return i % 2 == 1 ? 0.01F : 1.0F; });

  const auto groups = aggregate_pairs(graph);

  EXPECT_EQ(groups.count, 8u);
  for (std::uint32_t n = 0; n < 64; ++n)
    EXPECT_EQ(groups.of[n], groups.of[n / 8 * 8]);
}

TEST(Slivers, ConditionOfARegularTetIsOne) {
  EXPECT_NEAR(tet_condition({{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}}), 1, 1e-12);
  EXPECT_GT(tet_condition({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-4}}}), 100);
  EXPECT_TRUE(std::isinf(tet_condition({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}})));
}

TEST(Slivers, ThinTetsTieTheirNodesUpToTheLimit) {
  problem p;
  p.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-4}, {0, 0, 1}};
  p.element_nodes = {0, 1, 2, 3, 0, 1, 2, 4};
  p.element_tets = {0, 1};

  const auto all = cluster_slivers(p, std::vector<std::uint8_t>(5, 0));
  const auto few = cluster_slivers(p, std::vector<std::uint8_t>(5, 0), 2);
  const auto held = cluster_slivers(p, {1, 1, 1, 0, 0});

  ASSERT_EQ(all.count, 1u);
  EXPECT_EQ(all.of, (std::vector<std::uint32_t>{0, 0, 0, 0, no_id}));
  EXPECT_EQ(few.count, 2u);
  EXPECT_EQ(held.count, 0u);
}

}  // namespace
}  // namespace tedit::fem
