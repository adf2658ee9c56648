// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/quadratic_level.hpp"
#include "fem/native/cycle.hpp"
#include "fem/native/held_nodes.hpp"
#include "fem/native/quadratic.hpp"

namespace tedit::fem::native {

/// One symmetric cycle for quadratic tets: smoothing there, a correction from the linear tets of
/// the corners (p-multigrid), smoothing. Not for two threads at once.
template <class L = one_case>
class quadratic_cycle {
public:
  /// All arguments must outlive the cycle.
  quadratic_cycle(const quadratic_operator& k, const node_smoother& smoother,
                  const edge_transfer& edges, const held_nodes& held, multilevel_cycle<L>& corners,
                  int degree)
      : k_(k),
        smoother_(smoother),
        edges_(edges),
        held_(held),
        corners_(corners),
        degree_(degree),
        v_(k.rows()) {
    fit();
  }

  /// For an operator that has other rows now; `corners` is fitted apart.
  void fit() {
    v_.fit(k_.rows());
    coarse_right_.resize(L::size(edges_.corners()));
    coarse_.resize(coarse_right_.size());
  }

  /// z = about (S K S)^-1 right; both have `L::size` floats.
  void apply(const float* right, float* z);

  [[nodiscard]] std::uint64_t bytes() const { return v_.bytes(); }

private:
  using node = typename L::node;

  void restrict_residual();
  void prolongate();

  const quadratic_operator& k_;
  const node_smoother& smoother_;
  const edge_transfer& edges_;
  const held_nodes& held_;
  multilevel_cycle<L>& corners_;
  int degree_;
  node_vectors<L> v_;
  std::vector<float> coarse_right_, coarse_;
};

}  // namespace tedit::fem::native
