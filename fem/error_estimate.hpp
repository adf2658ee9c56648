// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/nodal_patches.hpp"
#include "fem/solver.hpp"

namespace tedit::fem {

/// Estimates the discretisation error after Zienkiewicz & Zhu (1987): per element eta_e^2 =
/// integral of (s* - s) : C^-1 : (s* - s), where s* is linear between the nodal means of the
/// patches, which are never taken across materials. For linear tets the estimate is known to
/// approach the true error; for quadratic ones s is itself linear, and the estimate measures its
/// jumps between elements, which is an indicator, not a bound. Fills `element_error`,
/// `relative_error` and `nodal_error`; needs `displacement` and `strain_energy_j`. Cost:
/// O(elements), on all cores.
void estimate_error(const problem& p, const nodal_patches& patches, const element_chunks& chunks,
                    solution& out);

/// Fills `singular_places`: corner nodes where the stress will go on growing when the mesh gets
/// finer, in linear elasticity without bound. A node is listed when all of this holds:
///  - its von Mises stress is at least half of the largest nodal one;
///  - an element around it has an error density eta_e^2/V of more than ten times the part's mean;
///  - it lies on the rim of a clamp (a surface holds it in all directions, and a boundary triangle
///    around it has a corner that is not held so), or on a re-entrant edge (two boundary triangles
///    around it meet at an edge where the part is concave, their normals more than 45 degrees
///    apart).
/// Weakness: one mesh cannot tell a singular peak from a steep one; a fillet or hole of eight or
/// fewer facets around looks like sharp edges; rims of loads and ends of material interfaces are
/// not looked at; where the error is about the same everywhere, as on a mesh with three elements
/// across, nothing is found. Two meshes of different fineness are the proof. Cost: O(elements).
void find_singular_places(const problem& p, const nodal_patches& patches, solution& out);

}  // namespace tedit::fem
