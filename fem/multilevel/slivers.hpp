// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

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

/// Joins the free nodes of tets with a condition above 10, worst first, into clusters of at most
/// `most` nodes. `excluded` marks nodes that are wholly held; nodes beyond its length do
/// not count, so that the corners of quadratic tets can be taken alone. Cost: O(elements).
[[nodiscard]] sliver_clusters cluster_slivers(const problem& p,
                                              const std::vector<std::uint8_t>& excluded,
                                              std::uint32_t most = 64, double condition = 10);

}  // namespace tedit::fem
