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

/// In a version of a CAD model new vertices that lie on chords of round walls go onto the walls, as
/// far as the model says what these are, or an earlier edit has made them: each to the nearest
/// point that is on all of its surfaces. The tets around follow, and
/// are mended; a vertex that finds no place, or whose tets would become worse than min(`floor`,
/// what they were), stays on its chord. Vertices at interfaces between regions stay. Nothing where
/// nothing has to move. So an edit that knows nothing of round walls leaves the part that its CAD
/// model is. Errors: `cancelled`. Cost: O(dirty slots), and of each surface at which there is
/// something to do a fit.
[[nodiscard]] expected<std::optional<settled_edit>> settle_on_walls(const mesh_version& base,
                                                                    const version_ptr& candidate,
                                                                    double floor,
                                                                    const execution& run);

}  // namespace tedit
