// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "client/surface.hpp"

/// Where a form that names no place puts its tool: by the server's rule, so that a handle stands
/// where the tool will be.
namespace tedit::desktop {

/// A point of the part's surface.
struct wall_spot {
  vec3 at;      ///< m.
  vec3 normal;  ///< Of the triangle there, unit, outward.

  friend bool operator==(const wall_spot&, const wall_spot&) = default;
};

/// The point of a surface that is nearest to its centroid; nothing for a surface without a facet.
/// Cost: O(facets).
[[nodiscard]] std::optional<wall_spot> middle_of(const client::surface_model& part,
                                                 surface_id surface);

/// The normal of the facet that is nearest to a point; of these surfaces, or of all where there are
/// none. Cost: O(facets).
[[nodiscard]] std::optional<vec3> outward_at(const client::surface_model& part, const vec3& at,
                                             const std::vector<surface_id>& of);

/// A bore, or what fits into one.
struct round_wall {
  vec3 middle;           ///< m: on the axis, half way along the wall.
  vec3 axis;             ///< Unit.
  double radius{};       ///< m.
  double half_length{};  ///< m: along the axis, to both sides.
};

/// The cylinder that some surfaces are together: with a round rim, and all vertices within 2 % of
/// its radius. Cost: O(facets log facets).
[[nodiscard]] std::optional<round_wall> round_wall_of(const client::surface_model& part,
                                                      const std::vector<surface_id>& surfaces);

}  // namespace tedit::desktop
