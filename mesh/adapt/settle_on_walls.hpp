// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/execution.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// A candidate whose new vertices have gone onto their walls.
struct settled_edit {
  version_ptr version;
  std::vector<tet_id> touched;  ///< What differs from the candidate.
};

/// Which vertices go: new ones alone, as an operation may have moved others on purpose, or all that
/// have moved, as where a mesh was improved.
enum class settling_vertices { fresh, moved };

/// In a version of a CAD model new vertices that lie on chords of round walls go onto the walls, as
/// far as the model says what these are, or an earlier edit has made them: each to the nearest
/// point that is on all of its surfaces. The tets around follow, and are mended. A vertex stays on
/// its chord where it finds no place, or where a tet at it would come out with a q = 3 r_in/R_circ
/// below `floor` and below all at these vertices before. Vertices at interfaces between regions
/// stay, too. Nothing where nothing has to move. So an edit that knows nothing of round walls
/// leaves the part that its CAD model is. Errors: `cancelled`. Cost: O(dirty slots), and for each
/// surface at which there is something to do O(facet slots) and a fit.
[[nodiscard]] expected<std::optional<settled_edit>> settle_on_walls(
  const mesh_version& base, const version_ptr& candidate, double floor, const execution& run,
  settling_vertices which = settling_vertices::fresh);

}  // namespace tedit
