// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/quadratic_level.hpp"
#include "fem/native/cycle.hpp"
#include "fem/native/quadratic_operator.hpp"

namespace tedit::fem {

/// One symmetric cycle for quadratic tets: smoothing there, a correction from the linear tets of
/// the corners (p-multigrid), smoothing. Not for two threads at once.
class quadratic_cycle {
public:
  /// All arguments must outlive the cycle.
  quadratic_cycle(const quadratic_operator& k, const node_smoother& smoother,
                  const edge_transfer& edges, multilevel_cycle& corners, int degree)
      : k_(k),
        smoother_(smoother),
        edges_(edges),
        corners_(corners),
        degree_(degree),
        v_(k.rows()),
        coarse_right_(padded3(edges.corners())),
        coarse_(padded3(edges.corners())) {}

  /// z = about (S K S)^-1 right; both have `padded3` floats.
  void apply(const float* right, float* z);

private:
  [[nodiscard]] float4 filtered(std::size_t node, float4 x) const {
    return edges_.filter.empty() ? x : multiply_symmetric(edges_.filter[node], x);
  }

  void restrict_residual();
  void prolongate();

  const quadratic_operator& k_;
  const node_smoother& smoother_;
  const edge_transfer& edges_;
  multilevel_cycle& corners_;
  int degree_;
  node_vectors v_;
  std::vector<float> coarse_right_, coarse_;
};

}  // namespace tedit::fem
