// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/hierarchy.hpp"

namespace tedit::fem {

/// The elements around a node of any kind as element * 10 + local node, ascending; `corners` has
/// those around corner nodes.
[[nodiscard]] std::vector<std::uint32_t> element_corners_at(const problem& quadratic,
                                                            const incidence& corners,
                                                            std::uint32_t node);

/// The prolongation from corners to all nodes of straight-sided quadratic tets: the middle of an
/// edge takes the mean of its ends, before filters. The matrix of the corners' linear tets is
/// exactly the Galerkin one.
struct edge_transfer {
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< Of node corners() + i.
  member_lists middles;                            ///< At each corner: ends index * 2 + side.

  [[nodiscard]] std::size_t corners() const { return middles.owners(); }
};

[[nodiscard]] edge_transfer make_edge_transfer(const problem& quadratic);

/// After edges were added.
void update_edge_transfer(const problem& quadratic, edge_transfer& edges);

/// The smoother's blocks of a problem of order 2, gathered from the elements, and dense inverses of
/// sliver clusters of at most 100 nodes. `lambda` is left to the caller, who has the operator.
/// Cost: O(elements).
[[nodiscard]] node_smoother make_quadratic_smoother(const problem& quadratic, filter_span filter,
                                                    const sliver_clusters& clusters);

/// Renews blocks and clusters where the elements around `nodes` (ascending) changed, and raises
/// `lambda` where large eigenvalues came up there. `corners` has the elements' corners. Cost: the
/// elements around, `lambda_steps` products with them.
void update_quadratic_smoother(const problem& quadratic, const incidence& corners,
                               filter_span filter, std::span<const std::uint32_t> nodes,
                               const multilevel_settings& settings,
                               std::vector<std::uint32_t>& cluster_of, node_smoother& smoother);

}  // namespace tedit::fem
