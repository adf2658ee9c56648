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
/// itself, and separate bodies; empty for a single, manifold body.
[[nodiscard]] std::vector<std::string> describe_boundary(const std::vector<boundary_facet>& facets,
                                                         const std::vector<tet>& tets,
                                                         const std::vector<adjacency>& neighbours,
                                                         std::size_t vertices);

}  // namespace tedit
