// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fem/problem.hpp"

/// Exact fields on a problem: boundary data and loads that a load case cannot say (it knows uniform
/// loads and one value per surface), and errors against the exact solution. Integrals use Gauss
/// points of degree 5 or more, so that what they miss stays far below the discretisation error.
namespace tedit::verification {

/// A displacement (m) or a force density (N/m^3) at a point.
using vector_field = std::function<vec3(vec3 at)>;

/// Stress at a point, Pa, in the order xx, yy, zz, xy, yz, zx.
using stress_field = std::function<std::array<double, 6>(vec3 at)>;

/// sigma n, Pa.
[[nodiscard]] vec3 traction_of(const std::array<double, 6>& stress, vec3 normal);

/// Removes all loads and supports, so that a case can set its own.
void clear_conditions(fem::problem& p);

/// Prescribes all three components of `u` at the nodes of the surfaces, mid nodes included.
void prescribe(fem::problem& p, const mesh_version& mesh, std::span<const surface_id> surfaces,
               const vector_field& u);

/// Prescribes component `axis` (0 to 2) of a node, m. The other components stay as they are.
void prescribe(fem::problem& p, std::size_t node, int axis, double value);

/// Adds the work-equivalent nodal forces of the traction sigma n on the surfaces. Exact for
/// stresses of degree 3 (order 2: 4 less the shape functions' 2).
void add_traction(fem::problem& p, const mesh_version& mesh, std::span<const surface_id> surfaces,
                  const stress_field& stress);

/// Adds the work-equivalent nodal forces of a force density, N/m^3.
void add_body_force(fem::problem& p, const vector_field& density);

/// Adds the nodal forces that a stress which no displacement causes exerts (a thermal strain, say):
/// the integral of B^T sigma. The stress of the part is then that of its strain less this one.
void add_initial_stress(fem::problem& p, const stress_field& stress);

/// The node nearest to a point; `corners_only` leaves mid nodes out.
[[nodiscard]] std::size_t nearest_node(const fem::problem& p, vec3 at, bool corners_only = false);

/// The nodes of the surfaces, ascending, mid nodes included.
[[nodiscard]] std::vector<std::size_t> nodes_on(const fem::problem& p, const mesh_version& mesh,
                                                std::span<const surface_id> surfaces);

/// Displacement of a node, m.
[[nodiscard]] vec3 node_value(std::span<const double> values, std::size_t node);

/// Largest |u_h - u| over all nodes, divided by the largest |u|.
[[nodiscard]] double largest_error(const fem::problem& p, std::span<const double> displacement,
                                   const vector_field& u);

/// Relative errors of a displacement field in two norms.
struct field_errors {
  double l2 = 0;      ///< sqrt(int |u_h - u|^2 / int |u|^2).
  double energy = 0;  ///< The same of the strain energy: sqrt(int e(d):C:e(d) / int e(u):C:e(u)).
};

/// Both by quadrature. `strain` gives the exact displacement gradient, rows du_i/dx. Cost:
/// O(elements) with 64 points each.
[[nodiscard]] field_errors errors_of(const fem::problem& p, std::span<const double> displacement,
                                     const vector_field& u,
                                     const std::function<std::array<vec3, 3>(vec3)>& gradient);

}  // namespace tedit::verification
