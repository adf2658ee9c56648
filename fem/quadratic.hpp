// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/element.hpp"

/// The quadratic tet with straight edges (T10). On corner k, barycentric e_k, its shape functions
/// N_k = L_k (2 L_k - 1), N_kb = 4 L_k L_b have the gradients 3 g_k (of N_k), -g_b (of N_b) and
/// 4 g_b (of N_kb), all others zero; g are the gradients of the linear tet. Strain and stress are
/// linear, so their corner values say all, and the integrals below are exact.
namespace tedit::fem {

/// Local node in the middle of corners a and b; the diagonal is not used.
inline constexpr std::array<std::array<int, 4>, 4> mid_node_of{
  {{0, 4, 6, 7}, {4, 0, 5, 8}, {6, 5, 0, 9}, {7, 8, 9, 0}}};

/// Corners on both sides of local node 4 + i.
inline constexpr std::array<std::array<int, 2>, 6> ends_of_mid_node{
  {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// The other three corners of each corner.
inline constexpr std::array<std::array<int, 3>, 4> other_corners{
  {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};

using corner_stresses = std::array<std::array<double, 6>, 4>;

/// Displacement gradient at corner k from the ten nodal displacements `u`, by differences to the
/// corner, so that rigid translations cancel before they are multiplied.
[[nodiscard]] inline std::array<vec3, 3> corner_gradient(const std::array<vec3, 10>& u,
                                                         const tet_gradients& g, int k) {
  std::array<vec3, 3> result{};
  for (const int b : other_corners[k]) {
    const vec3 d = 4.0 * (u[mid_node_of[k][b]] - u[k]) - (u[b] - u[k]);
    result[0] += d.x * g.gradient[b];
    result[1] += d.y * g.gradient[b];
    result[2] += d.z * g.gradient[b];
  }
  return result;
}

/// Stress at the four corners, Pa.
[[nodiscard]] inline corner_stresses stress_at_corners(const std::array<vec3, 10>& u,
                                                       const tet_gradients& g,
                                                       const lame_constants& c) {
  corner_stresses result;
  for (int k = 0; k < 4; ++k)
    result[k] = stress_of(corner_gradient(u, g, k), c);
  return result;
}

}  // namespace tedit::fem
