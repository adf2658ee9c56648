// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// A mesh as a file gives it: dense indices, nothing checked, lengths in the file's unit.
struct raw_mesh {
  struct triangle {
    std::array<vertex_id, 3> v;
    surface_id surface = 0;
    bool has_surface = true;  ///< False when the file gave no tag.
  };

  std::vector<vec3> positions;
  std::vector<tet> tets;
  std::vector<region_id> tet_regions;  ///< One for each tet.
  std::vector<triangle> triangles;
  std::vector<surface_info> surface_names;  ///< And geometries, in metres whatever the unit is.
  std::vector<region_info> region_names;
  /// File numbers for messages; empty means index + 1.
  std::vector<std::uint64_t> node_numbers;
  std::vector<std::uint64_t> tet_numbers;
};

/// Drops the vertices that are not used; no tet and no triangle may name one of them.
void keep_vertices(raw_mesh& raw, const std::vector<bool>& is_used);

/// Puts vertices and tets (by their middles) along a curve through space (mesh/morton.hpp). The
/// numbers of the file stay as they were. Returns where each vertex and each tet stood. All
/// positions must be finite. Cost: O(n).
[[nodiscard]] std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>> sort_along_curve(
  raw_mesh& raw);

}  // namespace tedit
