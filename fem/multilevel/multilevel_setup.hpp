// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "fem/block_matrix.hpp"
#include "fem/multilevel/quadratic_level.hpp"
#include "fem/problem_update.hpp"

namespace tedit::fem {

/// What a multilevel cycle is made of, set up on the host in the same way for every backend: the
/// blocks of linear tets (of quadratic ones: those of their corners), the hierarchy over them, and
/// for quadratic tets the smoother of all nodes and the transfer to the corners.
class multilevel_setup {
public:
  /// y = K x of quadratic tets, 3 numbers a node, on whatever device.
  using product = std::function<expected<void>(const float* x, float* y)>;

  /// Assembles the blocks; `p` must outlive this. Cost: O(elements), on all cores.
  multilevel_setup(const problem& p, const multilevel_settings& settings);

  /// Builds all but the blocks for the filter S of all nodes; `k` is asked with quadratic tets
  /// only, `lambda_steps` times. Errors: those of `build_hierarchy` and of `k`.
  [[nodiscard]] expected<void> prepare(filter_span filter, const product& k, const execution& run);

  /// The problem followed `change`, `corners` has its elements' corners: renews what that touches,
  /// with the problem's own filter. False when it cannot; then nothing here is to be used. Cost: as
  /// `update_hierarchy`.
  [[nodiscard]] bool update(const problem_change& change, const incidence& corners);

  /// The cycle turned out not to be positive definite: see `raise_lambda`.
  void raise_bounds();

  [[nodiscard]] const block_matrix& blocks() const { return blocks_; }
  [[nodiscard]] const hierarchy& levels() const { return hierarchy_; }
  [[nodiscard]] const node_smoother& smoother() const { return smoother_; }  ///< Of quadratic tets.
  [[nodiscard]] const edge_transfer& edges() const { return edges_; }        ///< The same.
  [[nodiscard]] std::uint64_t bytes() const;

  [[nodiscard]] filter_span at_corners(filter_span filter) const {
    return filter.first(problem_.corner_count);
  }
  /// Those of the changed nodes that are corners.
  [[nodiscard]] std::span<const std::uint32_t> changed_corners(const problem_change& change) const;

private:
  [[nodiscard]] expected<void> prepare_quadratic(filter_span filter, const product& k);

  const problem& problem_;
  multilevel_settings settings_;
  block_matrix blocks_;
  hierarchy hierarchy_;
  node_smoother smoother_;
  edge_transfer edges_;
  std::vector<std::uint32_t> cluster_of_;  ///< Sliver cluster of each node; empty: there are none.
};

}  // namespace tedit::fem
