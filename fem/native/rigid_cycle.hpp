// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/node_smoother.hpp"

namespace tedit::fem::native {

/// The rigid-body levels of a hierarchy: one symmetric cycle. Not for two threads at once.
template <class L = one_case>
class rigid_cycle {
public:
  /// `h` must outlive the cycle.
  rigid_cycle(const hierarchy& h, const cycle_settings& settings);

  /// For a hierarchy that has other rows now.
  void fit();

  /// result = about A_1^-1 right, both 6 per aggregate of the finest rigid level and case.
  void solve(std::span<const float> right, std::span<float> result) { solve(0, right, result); }

private:
  void solve(std::size_t level, std::span<const float> right, std::span<float> result);
  /// Chebyshev smoothing from z = 0; the residual still lacks the last step.
  void smooth_from_zero(std::size_t level, std::span<const float> right, std::span<float> z);
  /// Adds the coarser level's correction to `z` and smooths; the residual lacks the last step then,
  /// too.
  void correct(std::size_t level, std::span<float> z);
  /// As `chebyshev_move`.
  void move(std::size_t level, chebyshev_weights c, float enter, float* z);
  void solve_coarsest(std::span<const float> right, std::span<float> result) const;

  struct vectors {
    std::vector<float> residual, step, other;
    std::vector<float> down, up;  ///< What comes from the finer level and goes back.
  };

  const hierarchy& h_;
  cycle_settings settings_;
  std::vector<vectors> work_;
  std::vector<float> partial_;  ///< Of a restriction; empty before the first.
};

}  // namespace tedit::fem::native
