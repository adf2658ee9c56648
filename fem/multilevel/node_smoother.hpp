// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/block_rows.hpp"
#include "fem/multilevel/hierarchy.hpp"

namespace tedit::fem {

/// Adds factor * C^-1 r of the clusters' nodes to `d`.
template <class L = one_case>
void add_clusters(const cluster_inverses& clusters, float factor, const float* r, float* d);

/// d = factor * B r, with B the blocks and the clusters.
template <class L = one_case>
void apply_inverse(const node_smoother& smoother, float factor, const float* r, float* d);

/// The blocks of `k` inverted, cluster by cluster and node by node, within the free directions.
[[nodiscard]] node_smoother make_node_smoother(const block_matrix& k,
                                               std::span<const std::array<double, 6>> filter,
                                               const sliver_clusters& clusters);

/// The weights of step k >= 2 of the Chebyshev iteration of the fourth kind (Lottes 2023, algorithm
/// 1): d_k = before d_{k-1} + fresh D^-1 r. The first step is d_1 = 4/(3 lambda) D^-1 r.
struct chebyshev_weights {
  float before;
  float fresh;
};

[[nodiscard]] inline chebyshev_weights chebyshev_step(int k, float lambda) {
  const auto n = static_cast<float>(2 * k);
  return {(n - 3) / (n + 1), (4 * n - 4) / ((n + 1) * lambda)};
}

[[nodiscard]] inline float chebyshev_start(float lambda) {
  return 4 / (3 * lambda);
}

}  // namespace tedit::fem
