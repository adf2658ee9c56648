// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "fem/multilevel/lanes.hpp"

namespace tedit::fem::native {

/// a.b of each case, summed in double precision in a fixed order.
template <class L>
[[nodiscard]] case_sums<L> dots_of(const std::vector<float>& a, const std::vector<float>& b) {
  return sum_lanes<L>(a.size() / L::width, [&](std::size_t first, std::size_t last,
                                               typename L::sum& sum) TEDIT_INLINED {
    for (std::size_t i = first; i < last; ++i)
      L::add_product(L::load_scalar(a.data(), i), L::load_scalar(b.data(), i), sum);
  });
}

/// z += x, n values.
inline void add_to(const float* x, float* z, std::size_t n) {
  parallel_for(n, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      z[i] += x[i];
  });
}

}  // namespace tedit::fem::native
