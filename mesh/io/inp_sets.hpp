// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>

#include "mesh/version.hpp"

namespace tedit {

/// Writes the surfaces of a mesh as *SURFACE blocks of element faces. `element_of` says the number
/// that a tet has in the deck. Cost: O(facets).
void write_inp_surfaces(std::ostream& out, const mesh_version& mesh,
                        const std::function<std::size_t(tet_id)>& element_of);

/// What a deck needs beside nodes and elements so that ids and names come back: comments with the
/// names, an *ELSET for each region, the surfaces.
void write_inp_sets(std::ostream& out, const mesh_version& mesh,
                    const std::function<std::size_t(tet_id)>& element_of);

}  // namespace tedit
