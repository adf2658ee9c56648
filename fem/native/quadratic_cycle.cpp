// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/quadratic_cycle.hpp"

namespace tedit::fem::native {

template <class L>
void quadratic_cycle<L>::apply(const float* right, float* z) {
  smooth_from_zero<L>(k_, smoother_, degree_, right, v_, z);
  restrict_residual();
  corners_.apply(coarse_right_.data(), coarse_.data());
  prolongate();
  smooth_correction<L>(k_, smoother_, degree_, v_, z);
}

template <class L>
void quadratic_cycle<L>::restrict_residual() {
  const std::size_t corners = edges_.corners();
  filter_held<L>(held_, v_.residual.data());
  const float* r = v_.residual.data();
  for_lanes<L>(corners, [&](std::size_t first, std::size_t last) TEDIT_INLINED {
    for (std::size_t c = first; c < last; ++c) {
      node sum = L::load(r, c);
      for (const auto side : edges_.middles.of(c))
        sum += 0.5F * L::load(r, corners + side / 2);
      L::store(sum, coarse_right_.data(), c);
    }
  });
}

/// The correction of the corners, as a step of all nodes.
template <class L>
void quadratic_cycle<L>::prolongate() {
  const std::size_t corners = edges_.corners();
  const float* from = coarse_.data();
  float* step = v_.step.data();
  for_lanes<L>(k_.rows(), [&](std::size_t first, std::size_t last) TEDIT_INLINED {
    for (std::size_t n = first; n < last; ++n) {
      if (n < corners) {
        L::store(L::load(from, n), step, n);
        continue;
      }
      const auto [a, b] = edges_.ends[n - corners];
      L::store(0.5F * (L::load(from, a) + L::load(from, b)), step, n);
    }
  });
  filter_held<L>(held_, step);
}

template class quadratic_cycle<one_case>;
template class quadratic_cycle<cases_of<4>>;
template class quadratic_cycle<cases_of<8>>;

}  // namespace tedit::fem::native
