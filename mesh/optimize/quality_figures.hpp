// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// The shape of many tets in a few numbers.
struct quality_figures {
  std::uint64_t tets = 0;
  std::array<std::uint64_t, 18> dihedral{};  ///< All six angles of each tet, in bins of 10 deg.
  std::array<std::uint64_t, 10> ratio{};     ///< Radius ratios, in bins of 0.1.
  double min_ratio = 0;
  double ratio_1pct = 0;  ///< One tet in a hundred is worse.
  double mean_ratio = 0;
  double min_dihedral_deg = 0;
  double max_dihedral_deg = 0;
  double dihedral_1pct_deg = 0;  ///< One tet in a hundred has a smaller smallest angle.
};

/// The figures of `count` tets, given by their corners. On all cores; the same numbers on any.
/// Cost: O(count log count).
[[nodiscard]] quality_figures measure_quality(
  std::size_t count, const std::function<std::array<vec3, 4>(std::size_t)>& corners);

}  // namespace tedit
