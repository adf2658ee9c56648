// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/worst_first.hpp"

namespace tedit {

/// Flips that lower the sum of eta (Alexa 2019): 2-3 and 3-2 decided by the sign of one cotangent
/// weight, 4-4 and, where the boundary may change, 2-2 within a surface by the sum itself. None
/// makes a tet worse than min(floor, the worst that it replaces). Ends when no flip is left: each
/// lowers the sum by more than rounding. Throws `work_cancelled` (base/guard.hpp).
void flip_to_harmonic(work_mesh& mesh, const surface_guard& guard, double floor,
                      move_counts& counts);

/// One sweep that moves each interior vertex to the minimum of its star's energy, colour by colour
/// on all cores: no two vertices of a colour share a tet, so the result does not depend on the
/// number of threads. Moves are shortened until no tet is worse than min(floor, the star's worst).
/// Returns the sum of eta over the tets before the sweep. Throws `work_cancelled`.
double relocate_to_harmonic(work_mesh& mesh, double floor, move_counts& counts);

}  // namespace tedit
