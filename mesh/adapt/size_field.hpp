// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/facet_distance.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// Where on a part a mesh is to be finer or coarser: surfaces, or a ball.
struct mesh_pick {
  std::vector<surface_id> surfaces;
  std::optional<vec3> at;  ///< Instead of surfaces.
  double radius = 0;       ///< m, around `at`.
};

/// How far points are from what was picked.
class pick_distance {
public:
  /// Cost: O(n log n) in the picked facets.
  pick_distance(const mesh_version& mesh, const mesh_pick& pick);

  /// m, 0 within the ball; `at_most` where it is further.
  [[nodiscard]] double operator()(vec3 p, double at_most) const;

  /// The same for each vertex slot of a version; `at_most` where it is free. Cost: less, as slots
  /// that follow each other lie side by side.
  [[nodiscard]] std::vector<double> at_vertices(const mesh_version& mesh, double at_most) const;

private:
  mesh_pick pick_;
  facet_distance facets_;
};

/// By how much edges may be longer for each metre that they are further off: neighbours then differ
/// by a factor of less than two.
inline constexpr double size_growth = 0.75;

/// Mean length of the edges of tets that hold a picked facet, or a corner in the ball (of the
/// nearest vertex where there is none), m; 0 where there are none. Cost: O(mesh).
[[nodiscard]] double mean_size(const mesh_version& mesh, const mesh_pick& pick);

}  // namespace tedit
