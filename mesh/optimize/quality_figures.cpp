// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/quality_figures.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "base/parallel.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// The value that one in a hundred is below; the smallest of fewer than a hundred.
double one_percent(std::vector<double>& values) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 100);
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace

quality_figures measure_quality(std::size_t count,
                                const std::function<std::array<vec3, 4>(std::size_t)>& corners) {
  quality_figures result;
  result.tets = count;
  if (count == 0)
    return result;
  std::vector<double> ratios(count);
  std::vector<std::array<double, 6>> angles(count);
  parallel_for(count, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      const auto p = corners(i);
      ratios[i] = radius_ratio(p);
      angles[i] = dihedral_angles(p);
    }
  });
  std::vector<double> smallest(count);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += ratios[i];
    ++result.ratio[std::min<std::size_t>(9, static_cast<std::size_t>(10 * ratios[i]))];
    for (auto& angle : angles[i]) {
      angle *= 180 / std::numbers::pi;
      ++result.dihedral[std::min<std::size_t>(17, static_cast<std::size_t>(angle / 10))];
    }
    const auto [low, high] = std::ranges::minmax(angles[i]);
    smallest[i] = low;
    result.max_dihedral_deg = std::max(result.max_dihedral_deg, high);
  }
  result.mean_ratio = sum / static_cast<double>(count);
  result.min_ratio = std::ranges::min(ratios);
  result.min_dihedral_deg = std::ranges::min(smallest);
  result.ratio_1pct = one_percent(ratios);
  result.dihedral_1pct_deg = one_percent(smallest);
  return result;
}

}  // namespace tedit
