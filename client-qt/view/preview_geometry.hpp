// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/view/part_geometry.hpp"

namespace tedit::desktop {

/// What an edit would change of the boundary. Immutable; made on any thread. Either may be null
/// when there is no such facet.
struct preview_geometry {
  std::shared_ptr<const part_geometry> added;    ///< Facets that lie where no boundary was.
  std::shared_ptr<const part_geometry> removed;  ///< Facets of the head where none will be.
};

/// Compares by place: a wall that is only cut into other triangles has not changed.
/// Cost: O(facets), and a look at the other surface for each facet that is not the same.
[[nodiscard]] std::shared_ptr<const preview_geometry> differences_of(
  const client::surface_model& before, const client::surface_model& after);

}  // namespace tedit::desktop
