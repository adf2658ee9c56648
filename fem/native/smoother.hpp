// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/node_smoother.hpp"
#include "fem/native/vectors.hpp"
#include "fem/polled.hpp"

namespace tedit::fem::native {

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

}  // namespace tedit::fem::native
