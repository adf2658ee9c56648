// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "fem/problem.hpp"
#include "fem/wide.hpp"

namespace tedit::fem {

/// Gradients of the linear shape functions (1/m) and the volume (m^3) of a tet: grad N_a =
/// -A_a/(3V), A_a the outward area vector of the face opposite corner a.
struct tet_gradients {
  std::array<vec3, 4> gradient;
  double volume = 0;
};

[[nodiscard]] inline tet_gradients gradients_of(const std::array<vec3, 4>& p) {
  const vec3 u = p[1] - p[0];
  const vec3 v = p[2] - p[0];
  const vec3 w = p[3] - p[0];
  tet_gradients g;
  const double six_volumes = dot(u, cross(v, w));
  const double inverse = 1 / six_volumes;
  g.volume = six_volumes / 6;
  g.gradient[1] = cross(v, w) * inverse;
  g.gradient[2] = cross(w, u) * inverse;
  g.gradient[3] = cross(u, v) * inverse;
  g.gradient[0] = -(g.gradient[1] + g.gradient[2] + g.gradient[3]);
  return g;
}

/// The same for element e of a problem of any order: edges are straight, the corners say all.
[[nodiscard]] inline tet_gradients gradients_of(const problem& p, std::size_t e) {
  const auto* n = &p.element_nodes[static_cast<std::size_t>(p.nodes_per_element) * e];
  return gradients_of({p.nodes[n[0]], p.nodes[n[1]], p.nodes[n[2]], p.nodes[n[3]]});
}

/// Hooke's law: stress (xx, yy, zz, xy, yz, zx; Pa) from the rows, or the columns, of the
/// displacement gradient; of one element or of one in each lane. `twice_mu` is 2 mu.
template <class Scalar, class Row, class Modulus>
[[nodiscard]] TEDIT_INLINE std::array<Scalar, 6> stress_of(const Row& a, const Row& b, const Row& c,
                                                           Modulus lambda, Modulus mu,
                                                           Modulus twice_mu) {
  const Scalar pressure = lambda * (a.x + b.y + c.z);
  return {pressure + twice_mu * a.x, pressure + twice_mu * b.y, pressure + twice_mu * c.z,
          mu * (a.y + b.x),          mu * (b.z + c.y),          mu * (c.x + a.z)};
}

/// The same from the displacement gradient G_ij = du_i/dx_j.
[[nodiscard]] inline std::array<double, 6> stress_of(const std::array<vec3, 3>& g,
                                                     const lame_constants& c) {
  return stress_of<double>(g[0], g[1], g[2], c.lambda, c.mu, 2 * c.mu);
}

/// Displacement gradient of element e of a problem of order 1, from differences to its first node,
/// so that rigid translations cancel before they are multiplied.
[[nodiscard]] inline std::array<vec3, 3> displacement_gradient(const problem& p, std::size_t e,
                                                               const tet_gradients& g,
                                                               const double* displacement) {
  const auto* n = &p.element_nodes[4 * e];
  const double* first = displacement + 3 * n[0];
  std::array<vec3, 3> result{};
  for (int a = 1; a < 4; ++a) {
    const double* u = displacement + 3 * n[a];
    for (int i = 0; i < 3; ++i)
      result[i] += (u[i] - first[i]) * g.gradient[a];
  }
  return result;
}

/// sqrt(3/2 s:s) of a stress in Voigt order, Pa.
[[nodiscard]] inline double von_mises(const double* s) {
  const double a = s[0] - s[1];
  const double b = s[1] - s[2];
  const double c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

}  // namespace tedit::fem
