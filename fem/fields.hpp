// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "fem/solver.hpp"
#include "mesh/field.hpp"

namespace tedit::fem {

/// The arrays of a solution by the slots of its version: displacement_m (3), von_mises_pa,
/// stress_pa (6), reaction_n (3), principal_stress_pa (the largest) and, when a yield strength is
/// known, safety_factor at vertices; element_von_mises_pa, element_stress_pa (6),
/// element_error_sqrt_j at tets. Mid nodes of order 2 have no vertex and are left out: their
/// reactions, too, so take totals from the solution. Cost: O(mesh).
[[nodiscard]] std::vector<field> make_fields(const mesh_version& mesh, const problem& p,
                                             const solution& result);

}  // namespace tedit::fem
