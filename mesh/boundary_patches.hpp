// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// Gives every boundary facet whose `has_surface` entry is false a surface: that of the facets
/// around its patch where they are one surface that continues smoothly, else a new one. Patches end
/// at edges where the normals turn by more than 30 degrees. Returns the new surface ids, which
/// start above `largest`.
[[nodiscard]] std::vector<surface_id> assign_missing_surfaces(std::vector<boundary_facet>& facets,
                                                              const std::vector<bool>& has_surface,
                                                              const std::vector<vec3>& positions,
                                                              surface_id largest);

/// Sentences about edges with more than two boundary facets, vertices where the boundary touches
/// itself, separate bodies, vertices that lie on another one (bodies that touch and are not
/// joined), and a single surface id in spite of edges sharper than 30 degrees; empty for a single,
/// manifold body with surfaces. Cost: O(n log n) in the boundary's edges, O(tets).
[[nodiscard]] std::vector<std::string> describe_boundary(const std::vector<boundary_facet>& facets,
                                                         const std::vector<tet>& tets,
                                                         const std::vector<adjacency>& neighbours,
                                                         const std::vector<vec3>& positions);

}  // namespace tedit
