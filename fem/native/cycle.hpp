// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/native/rigid_cycle.hpp"
#include "fem/native/smoother.hpp"

namespace tedit::fem::native {

/// One symmetric multilevel cycle on a matrix of linear tets. Not for two threads at once.
template <class L = one_case>
class multilevel_cycle {
public:
  /// `k` and `h` must outlive the cycle.
  multilevel_cycle(const block_matrix& k, const hierarchy& h, const cycle_settings& settings);

  /// For a matrix and a hierarchy that have other rows now.
  void fit();

  /// z = about (S K S)^-1 right; both have `L::size` floats.
  void apply(const float* right, float* z);

  [[nodiscard]] std::uint64_t bytes() const { return v_.bytes(); }

private:
  void restrict_residual();
  void prolongate();

  const block_matrix& k_;
  const hierarchy& h_;
  cycle_settings settings_;
  rigid_cycle<L> rigid_;
  node_vectors<L> v_;
  std::vector<float> coarse_right_, coarse_;
};

}  // namespace tedit::fem::native
