// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fem/problem.hpp"

namespace tedit::fem {

/// How badly a tet is conditioned: the trace of its scalar Laplacian against that of a regular tet
/// of the same root-mean-square edge. 1 for a regular tet, about 2 for good ones, unbounded for
/// flat ones.
[[nodiscard]] double tet_condition(const std::array<vec3, 4>& corners);

/// Groups of nodes that thin tets tie together; their blocks are inverted together by the smoother.
struct sliver_clusters {
  std::vector<std::uint32_t> of;  ///< Cluster of each node; `no_id` for nodes in none.
  std::uint32_t count = 0;
};

/// 1 for each node that is wholly held.
[[nodiscard]] std::vector<std::uint8_t> wholly_held(std::span<const std::array<double, 6>> filter);

/// Joins the free nodes of tets with more than `condition` (0: none), worst first, into clusters of
/// at most `most` nodes. `excluded` marks nodes, as `wholly_held` does; nodes beyond its length do
/// not count, so that the corners of quadratic tets can be taken alone. Cost: O(elements).
[[nodiscard]] sliver_clusters cluster_slivers(const problem& p,
                                              const std::vector<std::uint8_t>& excluded,
                                              std::uint32_t most = 64, double condition = 10);

/// Clusters anew what changes at `nodes` (ascending) touch: dissolves the clusters of these nodes
/// and joins nodes along the thin tets around. `elements_at(n)` lists the elements around a node;
/// `excluded(n)` says which nodes do not count. Numbers of dissolved clusters are used again.
/// Cost: the elements around.
struct cluster_change {
  std::vector<std::uint32_t> nodes;                 ///< All that were or are concerned, ascending.
  std::vector<std::uint32_t> clusters;              ///< Whose members changed, ascending.
  std::vector<std::vector<std::uint32_t>> members;  ///< Of each of these; empty: it is gone.
};
[[nodiscard]] cluster_change recluster(
  const problem& p, std::span<const std::uint32_t> nodes,
  const std::function<bool(std::uint32_t node)>& excluded,
  const std::function<std::vector<std::uint32_t>(std::uint32_t node)>& elements_at,
  const std::function<std::span<const std::uint32_t>(std::uint32_t cluster)>& members_of,
  std::uint32_t most, double condition, sliver_clusters& clusters);

}  // namespace tedit::fem
