// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Core>

#include "fem/multilevel/hierarchy.hpp"

namespace tedit::fem {

/// The matrix of a cluster's nodes, 3 unknowns each.
using cluster_matrix_of = std::function<Eigen::MatrixXd(std::span<const std::uint32_t> nodes)>;

/// Gives the clusters of a smoother their dense inverses within the free directions, and zeroes the
/// blocks of their nodes. Cost: O(size^3) a cluster, on all cores.
void invert_clusters(const sliver_clusters& clusters, filter_span filter,
                     const cluster_matrix_of& matrix_of, node_smoother& smoother);

/// The inverse of a cluster's matrix within the free directions of its nodes.
[[nodiscard]] std::vector<float> invert_cluster(Eigen::MatrixXd m, filter_span filter,
                                                std::span<const std::uint32_t> nodes);

/// The matrix of some nodes, ascending, from the rows of `k`.
[[nodiscard]] Eigen::MatrixXd cluster_matrix(const block_matrix& k,
                                             std::span<const std::uint32_t> nodes);

/// How a smoother's blocks are found; linear and quadratic tets differ here.
struct smoother_source {
  const problem& p;
  filter_span filter;  ///< Nodes beyond it do not count.
  std::function<std::vector<std::uint32_t>(std::uint32_t node)> elements_at;
  std::function<std::array<float, 6>(std::uint32_t node)> diagonal_of;
  cluster_matrix_of matrix_of;
  std::uint32_t most = 64;  ///< Nodes of a cluster.
  double condition = 10;
};

/// Renews blocks and clusters after the rows of `nodes` (ascending) changed; returns the nodes
/// whose blocks or cluster changed. Cost: what is touched.
[[nodiscard]] std::vector<std::uint32_t> update_smoother(const smoother_source& source,
                                                         std::span<const std::uint32_t> nodes,
                                                         std::vector<std::uint32_t>& cluster_of,
                                                         node_smoother& smoother);

}  // namespace tedit::fem
