// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/quadratic.hpp"
#include "fem/solver.hpp"

namespace tedit::fem {

/// Stress at the corners of an element, Pa, in fp64 from the displacement (m, 3 per node): linear
/// between them over a quadratic tet, all the same over a linear one.
[[nodiscard]] corner_stresses corner_stress(const problem& p, std::span<const double> displacement,
                                            std::size_t element);

/// Its mean over the element: the stress at the centroid.
[[nodiscard]] std::array<double, 6> element_stress(const problem& p,
                                                   std::span<const double> displacement,
                                                   std::size_t element);

/// Eigenvalues of a stress in Voigt order, descending, Pa. In closed form: values that coincide
/// come out apart by up to 1e-8 of the largest one.
[[nodiscard]] std::array<double, 3> principal_values(const double* stress);

/// Divides the reactions among the surfaces that hold each node. A node's reaction r is shared as
/// if every surface held it by springs along the directions that it constrains, as stiff as its
/// area around the node is large: r_h = P_h y with (sum P_h) y = r. So a direction that one surface
/// alone holds is all its own, one that several hold is shared by area, and the sums add up to the
/// total. Ascending by surface. Cost: O(held nodes).
[[nodiscard]] std::vector<surface_reaction> reactions_by_surface(const problem& p,
                                                                 std::span<const double> reactions);

/// Fills everything of `out` that follows from its displacement, in fp64 on the host. Errors:
/// `invalid_load` when a number of the result is not finite or more than single precision holds, in
/// which fields are sent and stored. Cost: O(mesh), on all cores.
[[nodiscard]] expected<void> recover(const problem& p, const element_operator& k, solution& out);

}  // namespace tedit::fem
