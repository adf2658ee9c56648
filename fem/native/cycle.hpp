// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/node_smoother.hpp"
#include "fem/native/vectors.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

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

/// Vectors of a smoother on nodes with three unknowns.
template <class L>
struct node_vectors {
  std::vector<float> residual, step, other;

  explicit node_vectors(std::size_t nodes) { fit(nodes); }

  void fit(std::size_t nodes) {
    for (auto* v : {&residual, &step, &other})
      polled_resize(*v, L::size(nodes));
  }

  [[nodiscard]] std::uint64_t bytes() const { return 3 * residual.size() * sizeof(float); }
};

/// r -= K x.
template <class L, class Operator>
void subtract_product(const Operator& k, const float* x, float* r) {
  for_rows<L>(k, x, [&](std::size_t i, const typename L::node& row) TEDIT_INLINED {
    L::store(L::load_own(r, i) - row, r, i);
  });
}

/// Takes K step from the residual, finds the next step from what is left, and adds it, and `enter`
/// times the old one, to `z`.
template <class L, class Operator>
void chebyshev_move(const Operator& k, const node_smoother& smoother, chebyshev_weights w,
                    float enter, node_vectors<L>& v, float* z) {
  using node = typename L::node;
  float* r = v.residual.data();
  const float* step = v.step.data();
  float* next = v.other.data();
  const bool clusters = !smoother.clusters.empty();
  for_rows<L>(k, step, [&](std::size_t i, const node& row) TEDIT_INLINED {
    const node left = L::load_own(r, i) - row;
    L::store(left, r, i);
    const node old = L::load(step, i);
    const node now = w.before * old + w.fresh * multiply_symmetric(smoother.inverse[i], left);
    L::store(now, next, i);
    L::store(L::load_own(z, i) + enter * old + (clusters ? node{} : now), z, i);
  });
  if (clusters) {
    add_clusters<L>(smoother.clusters, w.fresh, r, next);
    add_to(next, z, 3 * L::width * smoother.inverse.size());
  }
  v.step.swap(v.other);
}

/// Chebyshev smoothing from z = 0: fills `z`, leaves right - K z in `v.residual`.
template <class L, class Operator>
void smooth_from_zero(const Operator& k, const node_smoother& smoother, int degree,
                      const float* right, node_vectors<L>& v, float* z) {
  const std::size_t n = 3 * L::width * smoother.inverse.size();
  std::copy_n(right, n, v.residual.data());
  apply_inverse<L>(smoother, chebyshev_start(smoother.lambda), right, v.step.data());
  std::copy_n(v.step.data(), n, z);
  for (int i = 2; i <= degree; ++i)
    chebyshev_move<L>(k, smoother, chebyshev_step(i, smoother.lambda), 0, v, z);
  subtract_product<L>(k, v.step.data(), v.residual.data());
}

/// Adds the correction in `v.step` to `z` and smooths: the mirror image of `smooth_from_zero`.
template <class L, class Operator>
void smooth_correction(const Operator& k, const node_smoother& smoother, int degree,
                       node_vectors<L>& v, float* z) {
  chebyshev_move<L>(k, smoother, {0, chebyshev_start(smoother.lambda)}, 1, v, z);
  for (int i = 2; i <= degree; ++i)
    chebyshev_move<L>(k, smoother, chebyshev_step(i, smoother.lambda), 0, v, z);
}

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

}  // namespace tedit::fem
