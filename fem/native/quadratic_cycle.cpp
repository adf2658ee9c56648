// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/quadratic_cycle.hpp"

namespace tedit::fem {

void quadratic_cycle::apply(const float* right, float* z) {
  smooth_from_zero(k_, smoother_, degree_, right, v_, z);
  restrict_residual();
  corners_.apply(coarse_right_.data(), coarse_.data());
  prolongate();
  smooth_correction(k_, smoother_, degree_, v_, z);
}

void quadratic_cycle::restrict_residual() {
  const std::size_t corners = edges_.corners();
  const float* r = v_.residual.data();
  parallel_for(corners, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t c = first; c < last; ++c) {
      float4 sum = filtered(c, load4(r + 3 * c));
      for (const auto side : edges_.middles.of(c)) {
        const std::size_t node = corners + side / 2;
        sum += splat(0.5F) * filtered(node, load4(r + 3 * node));
      }
      store3(sum, &coarse_right_[3 * c]);
    }
  });
}

/// The correction of the corners, as a step of all nodes.
void quadratic_cycle::prolongate() {
  const std::size_t corners = edges_.corners();
  parallel_for(k_.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      if (n < corners) {
        store3(load4(&coarse_[3 * n]), &v_.step[3 * n]);
        continue;
      }
      const auto [a, b] = edges_.ends[n - corners];
      const float4 mean =
        splat(0.5F) * (load4(&coarse_[3 * std::size_t{a}]) + load4(&coarse_[3 * std::size_t{b}]));
      store3(filtered(n, mean), &v_.step[3 * n]);
    }
  });
}

}  // namespace tedit::fem
