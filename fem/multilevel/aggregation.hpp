// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tedit::fem {

/// A symmetric weighted graph of nodes; rows as in `block_matrix`.
struct node_graph {
  std::vector<std::uint32_t> first;   ///< Nodes + 1.
  std::vector<std::uint32_t> column;  ///< Neighbours, without the node itself.
  std::vector<float>
    weight;  ///< |K_ij| / sqrt(|K_ii| |K_jj|): how strongly two nodes hang together.

  [[nodiscard]] std::uint32_t nodes() const { return static_cast<std::uint32_t>(first.size()) - 1; }
};

/// Which aggregate each node is in; `no_id` for nodes that are in none.
struct aggregation {
  std::vector<std::uint32_t> of;
  std::uint32_t count = 0;
};

/// Aggregates around a maximal independent set of distance 2 (Bell, Dalton & Olson 2012): a root
/// and its neighbours, about 15 nodes in a tet mesh; the others go to the strongest neighbouring
/// aggregate. Edges weaker than `weak` do not count as neighbours (stiffness jumps). Nodes whose
/// `excluded` is set are in no aggregate. Nodes of one `cluster` (`no_id`: none) end in one
/// aggregate. Aggregates of fewer than 4 nodes join their strongest neighbour. Deterministic.
/// Cost: about 15 visits an edge.
[[nodiscard]] aggregation aggregate_mis2(const node_graph& graph,
                                         std::span<const std::uint8_t> excluded,
                                         std::span<const std::uint32_t> cluster, float weak = 0.1F);

/// Groups of up to 2^`rounds` nodes by repeated matching along the strongest edges: slower
/// coarsening than `aggregate_mis2`, for upper levels. Deterministic. Cost: O(edges).
[[nodiscard]] aggregation aggregate_pairs(const node_graph& graph, int rounds = 3);

}  // namespace tedit::fem
