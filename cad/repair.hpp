// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cad/import.hpp"

namespace tedit::cad {

/// The worst tet (3 r_in / R_circ) that a part comes in with, unless its surface allows no better.
inline constexpr double least_quality = 0.05;

/// Gives an imported part's tets a better shape, as the operation `improve_mesh` does: without
/// moving the boundary first, then letting it go by a thousandth, and by a hundredth, of the edge
/// length that was asked for. Stops as soon as the worst tet has `least_quality`; says so in a
/// warning where it stays below. Errors: `cancelled` alone: a part that cannot be improved stays as
/// it is. Cost: O(mesh) and some seconds for each step; nothing where the mesh is good.
[[nodiscard]] expected<void> repair_part(imported_part& part, const execution& run);

}  // namespace tedit::cad
