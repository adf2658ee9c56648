// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/work_mesh.hpp"

namespace tedit {

/// Rings longer than this are not worth triangulating.
inline constexpr std::size_t longest_ring = 7;

/// The 2-3 flip of face `face` of tet t into `change`; false when a facet or wall is behind it or
/// one of the three tets would not be better than q = `above`.
[[nodiscard]] bool face_flip(const work_mesh& mesh, std::uint32_t t, int face, double above,
                             work_change& change);

/// The removal of edge a-b (3-2, 4-4, 5-6, ...): of all triangulations of the link polygon the one
/// whose worst tet is best (Klincsek's dynamic programme). An open ring is the boundary edge of two
/// facets of one surface; then the new facets close it, and a ring of one tet is just taken off.
/// False when some tet of each would not be better than q = `above`, or when an open ring's new
/// boundary edge exists already or its facets are of two surfaces.
[[nodiscard]] bool edge_removal(const work_mesh& mesh, const work_ring& ring, std::uint32_t a,
                                std::uint32_t b, double above, work_change& change);

}  // namespace tedit
