// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/version.hpp"

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
  std::vector<surface_info> surface_names;
  std::vector<region_info> region_names;
  /// File numbers for messages; empty means index + 1.
  std::vector<std::uint64_t> node_numbers;
  std::vector<std::uint64_t> tet_numbers;
};

/// A version with what a person should know about how it came to be.
struct built_version {
  version_ptr version;
  std::vector<std::string> warnings;
};

/// Builds topology and checks a raw mesh: positions are scaled to metres, tets of negative volume
/// that only have two corners swapped are turned (with a warning), unused vertices dropped, the
/// boundary extracted and matched with the triangles. Boundary faces without a triangle get one new
/// surface for each connected patch, with a warning.
/// Errors: `bad_input` for a vertex index out of range, a tet twice, a face in three tets, a
/// triangle that is no face of a tet or claimed by two surfaces, coordinates whose volumes
/// overflow. Cost: O(n log n). Exactly flat or inverted tets are kept and warned of; simulation
/// refuses them.
[[nodiscard]] expected<built_version> build_version(raw_mesh raw, double metres_per_unit);

}  // namespace tedit
