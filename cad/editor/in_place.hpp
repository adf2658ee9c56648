// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

#include "cad/editor/part.hpp"

namespace tedit::cad {

/// The part with walls moved as `shift` asks for, where no face and no edge comes or goes: the
/// surfaces of the walls are offset, those that go along are shifted, and each edge and vertex at
/// them is where the surfaces around it meet then, so that neighbours are trimmed or prolonged.
/// Nothing is intersected that did not meet before. Null where an edge or a vertex finds no place:
/// it would vanish, or its surfaces end. Throws a `Standard_Failure` where OpenCASCADE gives up.
/// Cost: O(faces at the walls), an intersection of surfaces for each of their edges at most.
[[nodiscard]] TopoDS_Shape moved_in_place(const part_model& part, const cad_step& step);

}  // namespace tedit::cad
