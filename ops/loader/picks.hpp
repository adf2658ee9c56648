// SPDX-License-Identifier: AGPL-3.0-or-later
// Places that a request names by what the part has there: "surface:12", "edge:3,7", "corner:3,7,9".
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Whether a text names a place of the part instead of numbers. That it is there is not said.
[[nodiscard]] bool is_pick(std::string_view text);

/// The surfaces by which a text, or several with semicolons between, names places of the part; none
/// where it has numbers only. That they are there is not said.
[[nodiscard]] std::vector<surface_id> surfaces_of_picks(std::string_view text);

/// What there is at a place of the part.
struct picked_place {
  /// m: half way along the axis of what is round; of an edge and of a wall its middle.
  vec3 point;
  vec3 direction;  ///< Unit: of the axis, along a straight edge, across what is flat; else 0.
  std::vector<vec3> polyline = {};  ///< m: of an edge; where it is closed, the first point again.
};

/// Finds it. A round wall or cone gives its axis, a flat wall its outward normal, any other wall
/// only a middle; an edge its circle's axis, or its own line; a corner of three or more surfaces
/// the point. Errors: `invalid_parameter` for what is no such text or fits several places,
/// `surface_not_found`. Cost: O(facets of the surfaces), for walls O(facet slots).
[[nodiscard]] expected<picked_place> find_pick(const mesh_version& mesh, std::string_view text);

}  // namespace tedit::ops
