// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/aggregation.hpp"

#include <algorithm>
#include <atomic>
#include <map>

#include "base/parallel.hpp"
#include "fem/polled.hpp"
#include "mesh/types.hpp"

namespace tedit::fem {

namespace {

std::uint64_t mix(std::uint64_t x) {
  // The finaliser of splitmix64: neighbours get unrelated priorities.
  x += 0x9E3779B97F4A7C15;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
  return x ^ (x >> 31);
}

class mis2_builder {
public:
  mis2_builder(const node_graph& graph, std::span<const std::uint8_t> excluded, float weak)
      : graph_(graph), excluded_(excluded), weak_(weak) {
    result_.of.assign(graph.nodes(), no_id);
  }

  aggregation run(std::span<const std::uint32_t> cluster) {
    choose_roots();
    // Chains of leftovers end: each round joins those that touch an aggregate.
    while (join_leftovers()) {
    }
    lone_nodes();
    glue(cluster);
    merge_small(4);
    renumber();
    return std::move(result_);
  }

private:
  template <class Visit>
  void for_strong(std::uint32_t node, Visit&& visit) const {
    for (auto s = graph_.first[node]; s < graph_.first[node + 1]; ++s)
      if (graph_.weight[s] >= weak_ && excluded_[graph_.column[s]] == 0)
        visit(graph_.column[s]);
  }

  /// Calls `visit` for every node, on all cores.
  template <class Visit>
  void for_each_node(const Visit& visit) const {
    parallel_for(graph_.nodes(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t n = first; n < last; ++n)
        visit(static_cast<std::uint32_t>(n));
    });
  }

  void choose_roots() {
    struct candidate {
      std::uint64_t key;
      std::uint32_t node;
    };
    std::vector<candidate> order(graph_.nodes());
    for (std::uint32_t n = 0; n < order.size(); ++n)
      order[n] = {mix(n), n};
    polled_sort(order, [](const candidate& a, const candidate& b) { return a.key < b.key; });
    std::vector<std::uint8_t> covered(order.size(), 0);
    polled_for(order.size(), [&](std::size_t i) {
      const auto root = order[i].node;
      if (covered[root] != 0 || excluded_[root] != 0)
        return;
      covered[root] = 1;
      result_.of[root] = result_.count;
      for_strong(root, [&](std::uint32_t near) {
        covered[near] = 1;
        result_.of[near] = result_.count;
        for_strong(near, [&](std::uint32_t far) { covered[far] = 1; });
      });
      ++result_.count;
    });
  }

  /// The aggregate of the strongest neighbour that is in one of `from`.
  [[nodiscard]] std::uint32_t strongest(std::uint32_t node, const std::vector<std::uint32_t>& from,
                                        float least) const {
    std::uint32_t best = no_id;
    float weight = least;
    for (auto s = graph_.first[node]; s < graph_.first[node + 1]; ++s)
      if (const auto there = from[graph_.column[s]]; there != no_id && graph_.weight[s] > weight) {
        weight = graph_.weight[s];
        best = there;
      }
    return best;
  }

  bool join_leftovers() {
    const auto before = result_.of;
    std::atomic<bool> joined = false;
    for_each_node([&](std::uint32_t n) {
      if (before[n] == no_id && excluded_[n] == 0)
        if (const auto there = strongest(n, before, weak_); there != no_id) {
          result_.of[n] = there;
          joined.store(true, std::memory_order_relaxed);
        }
    });
    return joined;
  }

  void lone_nodes() {
    for (std::uint32_t n = 0; n < graph_.nodes(); ++n)
      if (result_.of[n] == no_id && excluded_[n] == 0)
        result_.of[n] = result_.count++;
  }

  void glue(std::span<const std::uint32_t> cluster) {
    std::map<std::uint32_t, std::uint32_t> to;
    polled_for(cluster.size(), [&](std::size_t n) {
      if (cluster[n] != no_id && result_.of[n] != no_id)
        result_.of[n] = to.try_emplace(cluster[n], result_.of[n]).first->second;
    });
  }

  void merge_small(std::uint32_t least) {
    std::vector<std::uint32_t> size(result_.count, 0);
    for (const auto a : result_.of)
      if (a != no_id)
        ++size[a];
    std::vector<std::uint32_t> kept(result_.of);
    for (auto& a : kept)
      if (a != no_id && size[a] < least)
        a = no_id;
    for_each_node([&](std::uint32_t n) {
      if (result_.of[n] != no_id && kept[n] == no_id)
        if (const auto there = strongest(n, kept, 0); there != no_id)
          result_.of[n] = there;
    });
  }

  void renumber() {
    std::vector<std::uint32_t> number(result_.count, no_id);
    result_.count = 0;
    for (auto& a : result_.of)
      if (a != no_id) {
        if (number[a] == no_id)
          number[a] = result_.count++;
        a = number[a];
      }
  }

  const node_graph& graph_;
  std::span<const std::uint8_t> excluded_;
  float weak_;
  aggregation result_;
};

/// Each node with its strongest free neighbour; both get one number.
aggregation match(const node_graph& graph) {
  aggregation result;
  result.of.assign(graph.nodes(), no_id);
  polled_for(graph.nodes(), [&](std::size_t i) {
    const auto n = static_cast<std::uint32_t>(i);
    if (result.of[n] != no_id)
      return;
    std::uint32_t best = no_id;
    float weight = 0;
    for (auto s = graph.first[n]; s < graph.first[n + 1]; ++s)
      if (const auto other = graph.column[s];
          other != n && result.of[other] == no_id && graph.weight[s] > weight) {
        weight = graph.weight[s];
        best = other;
      }
    result.of[n] = result.count;
    if (best != no_id)
      result.of[best] = result.count;
    ++result.count;
  });
  return result;
}

/// The graph of the groups; weights between two groups add up.
node_graph collapse(const node_graph& graph, const aggregation& groups) {
  std::vector<std::vector<std::uint32_t>> members(groups.count);
  for (std::uint32_t n = 0; n < graph.nodes(); ++n)
    members[groups.of[n]].push_back(n);
  node_graph result;
  result.first.push_back(0);
  std::vector<std::uint32_t> place(groups.count, no_id);
  polled_for(groups.count, [&](std::size_t g) {
    for (const auto n : members[g])
      for (auto s = graph.first[n]; s < graph.first[n + 1]; ++s) {
        const auto other = groups.of[graph.column[s]];
        if (other == g)
          continue;
        if (place[other] == no_id || place[other] < result.first[g]) {
          place[other] = static_cast<std::uint32_t>(result.column.size());
          result.column.push_back(other);
          result.weight.push_back(0);
        }
        result.weight[place[other]] += graph.weight[s];
      }
    result.first.push_back(static_cast<std::uint32_t>(result.column.size()));
  });
  return result;
}

}  // namespace

aggregation aggregate_mis2(const node_graph& graph, std::span<const std::uint8_t> excluded,
                           std::span<const std::uint32_t> cluster, float weak) {
  return mis2_builder(graph, excluded, weak).run(cluster);
}

aggregation aggregate_pairs(const node_graph& graph, int rounds) {
  aggregation result = match(graph);
  node_graph now = collapse(graph, result);
  for (int round = 1; round < rounds; ++round) {
    const aggregation next = match(now);
    now = collapse(now, next);
    for (auto& a : result.of)
      a = next.of[a];
    result.count = next.count;
  }
  return result;
}

}  // namespace tedit::fem
