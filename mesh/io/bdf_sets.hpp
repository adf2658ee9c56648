// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>

#include "base/error.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// The number of the property that a region's tets have in a deck of Nastran: the region's id where
/// all of them can be numbers there, else its place in the table, from 1.
[[nodiscard]] std::uint64_t bdf_property(const mesh_version& mesh, region_id region);

/// Comments with the unit, ids and names, for the head of a deck.
void write_bdf_names(std::ostream& out, const mesh_version& mesh, std::string_view length_unit);

/// Writes the surfaces as BSURFS: faces of tets by their corners, which are of no meaning to a
/// solution that does not ask for them. Cost: O(facets).
void write_bdf_surfaces(std::ostream& out, const mesh_version& mesh,
                        const std::function<std::uint64_t(tet_id)>& element_of,
                        const std::function<std::uint64_t(vertex_id)>& node_of);

}  // namespace tedit
