// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/level_set_patch.hpp"

namespace tedit {

/// Moves a flat surface by `distance` (m, outward; negative: into the material) by its vertices
/// alone, parallel to itself: those on its border stay on every neighbouring facet's plane, so that
/// neighbours are trimmed or prolonged. Outward it goes straight up, so neighbours must stand at
/// right angles. Nothing is cut or added, ids and topology stay. True when it
/// was done; false, with nothing changed, where a neighbour runs on flush with the surface, where
/// neighbours leave a vertex no way, where the surface would run into another part of the boundary,
/// where a neighbour that is not flat would be left (its facets' planes are chords), or where a tet
/// would come out worse than min(floor, what it was): a larger change is then to be
/// cut or filled. Cost: O(surface); outward O(facet slots).
[[nodiscard]] bool shift_patch(mesh_builder& mesh, const surface_patch& patch, double distance,
                               double floor);

}  // namespace tedit
