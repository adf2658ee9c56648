// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// What a protrusion stands on: the boundary across a run of inner corners around it.
struct foot {
  std::vector<facet_id> facets;  ///< Unselected facets at the foot's edges.
  vec3 point;                    ///< Area-weighted centre of their plane.
  vec3 normal;                   ///< Unit, outward: towards the protrusion.
  double deviation = 0;          ///< Largest distance of their corners from the plane, m.
  double length = 0;             ///< Of the foot's edges, m.
  bool flat = true;              ///< Within 1e-4 of the selection's size of its plane.
};

/// A boss, rib or fin as the surfaces that belong to it alone, and what it stands on. Surfaces that
/// it shares with the rest of the part (the end faces of an extruded heat sink) are not listed.
struct protrusion {
  std::vector<surface_id> surfaces;  ///< With those that were added, ascending.
  std::vector<surface_id> added;
  std::vector<foot> feet;  ///< One for each plane; coplanar ones are one.
  double size = 0;         ///< Diagonal of the selected facets' box, m.
};

/// Grows a selection over its outer edges (material angle below 179 degrees) and over rounded
/// corners to the whole protrusion: a surface is added when no part of it lies below a foot. Inner
/// corners (above 181 degrees, or where a root fillet ends) are the foot. With `exact` nothing is
/// added. Errors: `empty_selection`, `not_a_protrusion` when there is no foot.
/// Cost: O(facet slots) for each surface that is added.
[[nodiscard]] expected<protrusion> complete_protrusion(const mesh_version& mesh,
                                                       const std::vector<surface_id>& surfaces,
                                                       bool exact);

}  // namespace tedit
