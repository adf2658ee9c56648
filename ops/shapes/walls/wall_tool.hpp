// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>

#include "ops/shapes/walls/moving_walls.hpp"

namespace tedit::ops {

/// The space between walls and where they go, as a tool for a boolean: what is cut off or added.
struct wall_tool {
  tool_surface tool;
  /// Of each face: the surface of the part that it is a part of; nothing for a new one.
  std::vector<std::optional<surface_id>> continues;
  std::set<surface_id> smooth;  ///< Neighbours that run on smoothly, beside which a step is left.
  std::vector<vec3> places;     ///< Where vertices of the walls go that stay on the part.
  double edge = 0;              ///< Mean edge of the walls, m.
};

/// Each wall's own triangles, the same ones where they go (each vertex to `distance` off the walls
/// that it lies on, m; outward, negative: into the material), and sides between the two. At a
/// neighbour that runs on smoothly the side is a step along the wall's normal. Where material is
/// taken off, a neighbour that goes down is cut to where the part ends; where it is put on, a
/// neighbour that rises is run into, and one that goes down at about a right angle goes up with the
/// wall. Where material is taken off a wall that ends at another region, the side reaches into that
/// one, of which the boolean takes nothing (`services::boolean_onto`). In a part of a CAD file a
/// step above a round rim says that it is a cylinder (`step_geometry`). Errors: `invalid_argument`
/// where the distance is less than a two-hundredth of the edges there, and where a wall bends too
/// sharply for it. Cost: O(facet slots + border edges x facets near).
[[nodiscard]] expected<wall_tool> make_wall_tool(const mesh_version& mesh, const wall_set& walls,
                                                 double distance);

}  // namespace tedit::ops
