// SPDX-License-Identifier: AGPL-3.0-or-later
// Flat walls that move, by the pieces of a slab that the mesh has.
#pragma once

#include "cad/editor/ways.hpp"

namespace tedit::cad {

/// What divides a slab beside the part itself.
enum class slab_division {
  edges,          ///< Straight up or down from the wall's edges.
  edges_around,   ///< And from those of the faces beside it.
  planes_around,  ///< From the wall's edges, and the planes of the faces around.
  edges_beyond    ///< From those of the faces beside these, too.
};

/// Takes off, or puts on, what lies between the plane of each wall and that plane moved outward by
/// `distance_mm` (below zero: into the part), as far as the edited mesh has done so: the slab is
/// divided by the part, and where the mesh may end what it changes, and of each piece the mesh says
/// whether it is material. So it does not matter whether a neighbour is run into, cut, or left with
/// a step. Null where the walls are of several solids or no piece changes.
[[nodiscard]] TopoDS_Shape moved_by_slab(const part_model& part,
                                         const std::vector<TopoDS_Face>& walls, double distance_mm,
                                         slab_division by, const edited_surface& mesh);

}  // namespace tedit::cad
