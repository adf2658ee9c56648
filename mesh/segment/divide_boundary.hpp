// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/raw_mesh.hpp"

namespace tedit {

/// Gives the boundary facets whose `has_surface` entry is false a surface, and says so in a
/// sentence; empty where there are none. Where the file says no surface at all they become planes,
/// cylinders, cones, spheres and free forms (mesh/segment/segment.hpp) with ids from 1 and names
/// like "plane 1" and "cylinder 3 d 8 mm" in `raw`; else patches by `assign_missing_surfaces`.
/// Positions are in m. Cost: as `segment_surface`.
[[nodiscard]] std::string give_missing_surfaces(raw_mesh& raw, std::vector<boundary_facet>& facets,
                                                const std::vector<bool>& has_surface);

}  // namespace tedit
