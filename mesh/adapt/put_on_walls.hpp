// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "base/execution.hpp"
#include "mesh/builder.hpp"
#include "mesh/features/exact_wall.hpp"

namespace tedit {

/// The exact wall behind a surface at a point; null for free form.
using wall_finder = std::function<const exact_wall*(surface_id surface, vec3 at)>;

struct walls_report {
  std::size_t moved = 0;
  std::size_t left = 0;  ///< Vertices that found no place, or would have made tets too flat.
  double furthest = 0;   ///< m: how far those that were left are off their walls at most.
  bool changed = false;  ///< Is anything elsewhere? Some that were left may have gone half way.
};

/// Puts the vertices of the skin that the base does not have (or has elsewhere) onto the round
/// walls at them: on a rim where both walls meet, at a corner where three do. Planes and free form
/// are kept as they lie there. All go at once, then those go back at which a tet would be turned
/// over or be worse than min(0.1, the worst around the vertex before), then these are tried one by
/// one, with the tets around improved. Vertices between regions stay. Deterministic. Errors:
/// `cancelled`. Cost: O(touched tets), O(star) for each vertex.
[[nodiscard]] expected<walls_report> put_on_walls(mesh_builder& mesh, const wall_finder& wall_at,
                                                  const execution& run);

/// The same with the walls that the base has, but for surfaces that the edit has moved.
[[nodiscard]] expected<walls_report> put_on_walls_of_base(
  mesh_builder& mesh, const std::function<bool(surface_id)>& has_moved, const execution& run);

}  // namespace tedit
