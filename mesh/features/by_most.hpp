// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace tedit {

/// Rounds after which weights by most settle what they settle.
inline constexpr int rounds_by_most = 12;

/// How much each point counts in a fit that most points agree on: Cauchy's weights, by the median
/// of how far they are off. CAD programs let a face's corners be a little off it, where others meet
/// it; those within are on it to rounding. `least`: what is rounding.
[[nodiscard]] inline std::vector<double> weights_by_most(std::vector<double> off, double least) {
  auto sorted = off;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  const double scale = std::max(*middle, least);
  for (auto& one : off)
    one = 1 / (1 + one * one / (scale * scale));
  return off;
}

}  // namespace tedit
