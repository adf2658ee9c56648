// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/raw_mesh.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// How the slots of a version follow each other.
enum class slot_order {
  as_given,    ///< As the raw mesh lists vertices and tets.
  along_curve  ///< Along a curve through space, where the mesh has more tets than a page:
               ///< neighbours lie in the same pages, so that an edit touches few. The version keeps
               ///< the order of the raw mesh for what is written to files.
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
[[nodiscard]] expected<built_version> build_version(raw_mesh raw, double metres_per_unit,
                                                    slot_order order = slot_order::as_given);

}  // namespace tedit
