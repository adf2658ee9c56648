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

}  // namespace tedit::fem
