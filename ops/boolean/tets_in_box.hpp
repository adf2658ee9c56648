// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/box.hpp"
#include "mesh/version.hpp"

namespace tedit::ops {

/// All live tets that have a point in a box, ascending, and some whose boxes only meet it.
/// @param near all live facets that have a point in the box; there may be more.
/// Cost: O(facets near + tets found); O(tet slots) where no facet's edge passes through the box, or
/// most of the part may be in it.
[[nodiscard]] std::vector<tet_id> tets_in_box(const mesh_version& mesh, const box& where,
                                              const std::vector<facet_id>& near);

/// All live facets whose boxes meet a box, ascending; `all` becomes that of all live facets.
/// Cost: O(facet slots).
[[nodiscard]] std::vector<facet_id> facets_in_box(const mesh_version& mesh, const box& where,
                                                  box& all);

}  // namespace tedit::ops
