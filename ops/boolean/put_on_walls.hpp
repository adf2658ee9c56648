// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/boolean/round_walls.hpp"

namespace tedit::ops {

/// A cleaned surface with all its new vertices on the round walls.
struct rounded_surface {
  labelled_surface surface;
  double volume_change = 0;  ///< m^3: by how much what it bounds has become more.
};

/// What came of putting them on.
struct put_on_outcome {
  std::optional<rounded_surface> made;
  bool wanted = false;     ///< Vertices lie on chords: nothing made is then a failure.
  bool has_places = true;  ///< Each vertex has a place on all of its walls.
};

/// The last step before the mesher: new vertices that lie on the chords of round walls go onto the
/// walls, each onto all of its walls at once; planes stay planes. Vertices beside, which they would
/// run into, go along within their faces; long chords in the way are halved, short edges
/// contracted. Nothing where no vertex has to move, or where not all of them can without a triangle
/// turning over or becoming flat: half of them would be no better for anybody. Cost: O(new
/// vertices), and a fit of each wall once.
[[nodiscard]] put_on_outcome put_on_round_walls(const labelled_surface& surface,
                                                round_walls& walls);

}  // namespace tedit::ops
