// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// Where an edit meets what somebody else has changed meanwhile.
struct edit_overlap {
  std::size_t tets = 0;              ///< That both change.
  std::vector<surface_id> surfaces;  ///< On the boundary of those. Ascending.
  std::vector<surface_id>
    reshaped;  ///< Of those that the edit names: with other facets than they had. Ascending.

  /// Nobody who asked for the edit would miss anything.
  [[nodiscard]] bool none() const { return tets == 0 && reshaped.empty(); }
};

/// An edit was asked for by somebody who looked at `seen`, and was made on `head`, with `edited` as
/// its result. Which tets of `head` does it take, replace or reshape that `seen` has not, or not
/// so; and which of the surfaces that it `named` has other facets than in `seen`? Where there is
/// none of either, all that the edit touches is as it was seen. Corners are compared by vertex and
/// place, so that `seen` may lie on another branch of the document. Cost: O(pages that differ,
/// facets of `head`).
[[nodiscard]] edit_overlap overlap_of(const mesh_version& seen, const mesh_version& head,
                                      const mesh_version& edited,
                                      std::span<const surface_id> named);

}  // namespace tedit
