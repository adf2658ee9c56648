// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "fem/multilevel/hierarchy.hpp"
#include "fem/multilevel/lanes.hpp"

namespace tedit::fem::native {

/// S of the nodes that are not free.
using held_nodes = std::vector<std::pair<std::uint32_t, std::array<float, 6>>>;

[[nodiscard]] inline held_nodes held_nodes_of(filter_span filter) {
  held_nodes result;
  for (std::uint32_t n = 0; n < filter.size(); ++n)
    if (filter[n] != std::array<double, 6>{1, 0, 0, 1, 0, 1}) {
      auto& [node, s] = result.emplace_back(n, std::array<float, 6>{});
      std::ranges::transform(filter[n], s.begin(), [](double v) { return static_cast<float>(v); });
    }
  return result;
}

/// x = S x.
template <class L>
void filter_held(const held_nodes& held, float* x) {
  for (const auto& [node, s] : held)
    L::store(multiply_symmetric(s, L::load_own(x, node)), x, node);
}

}  // namespace tedit::fem::native
