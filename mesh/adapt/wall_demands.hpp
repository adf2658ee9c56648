// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/features/exact_wall.hpp"

namespace tedit {

/// What a vertex of the skin must lie on.
struct wall_demand {
  const exact_wall* wall = nullptr;  ///< Null: the plane through where the vertex is.
  vec3 normal;                       ///< Unit; of that plane.
  bool free_form = false;            ///< Nobody knows whether the wall is that plane.
};

/// A place on all that is demanded.
struct wall_place {
  vec3 at;
  double before = 0;   ///< m: how far the vertex is off the walls.
  double after = 0;    ///< m: and the place.
  bool found = false;  ///< False also where the walls touch without crossing, or too far away.

  /// Is there nothing to do?
  [[nodiscard]] bool is_there() const { return found && before == after; }
};

/// The nearest point to `start` on the walls and planes: Gauss-Newton with the shortest steps, for
/// more than three demands in the least squares sense. It may be half of the least radius away.
/// Free form that a round wall runs into smoothly demands nothing: its plane is a chord of both.
/// Cost: some small singular value decompositions.
[[nodiscard]] wall_place place_on_walls(const std::vector<wall_demand>& demands, vec3 start);

/// The planes of facets of one surface at a vertex, given by their area vectors: one, or one on
/// each side of a crease.
void add_planes(const std::vector<vec3>& areas, bool free_form, std::vector<wall_demand>& demands);

}  // namespace tedit
