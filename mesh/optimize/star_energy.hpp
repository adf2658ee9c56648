// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/vec3.hpp"

namespace tedit {

/// A symmetric 3 x 3 matrix: xx, yy, zz, xy, yz, zx.
struct sym3 {
  std::array<double, 6> m{};
};

/// The solution of h x = b, or nothing when h is not positive definite.
[[nodiscard]] std::optional<vec3> solve(const sym3& h, vec3 b);

/// The tets around one vertex x, each by its face (p0, p1, p2) opposite x, so that
/// det[p1-p0, p2-p0, x-p0] > 0: all that functions of x alone need.
struct vertex_star {
  std::vector<std::array<vec3, 3>> faces;

  void add(const std::array<vec3, 4>& corners, int at);
};

// -- the harmonic energy of a star: f(x) = sum of eta over its tets, in m ----------------------
// eta = N / V with N = sum |A_i|^2, a quadratic function of x over an affine one: f is convex where
// all V > 0, and its own barrier (Alexa 2019; docs/improve.md).

/// +infinity when a volume is not positive.
[[nodiscard]] double star_energy(const vertex_star& star, vec3 x);

/// grad f, without unit (m / m); every volume must be positive.
[[nodiscard]] vec3 star_gradient(const vertex_star& star, vec3 x);

/// The second derivatives of f, 1/m; positive definite where all volumes are.
[[nodiscard]] sym3 star_hessian(const vertex_star& star, vec3 x);

/// How far x can go along a direction, in its lengths, until the first tet is flat; +infinity when
/// none gets flatter. Exact but for rounding: volumes are affine in x.
[[nodiscard]] double longest_step(const vertex_star& star, vec3 x, vec3 along);

/// Newton's method with backtracking from x, where all volumes are positive: at most `steps` steps,
/// each at most 0.9 of the longest. Comes to the star's only minimum when it may take enough.
[[nodiscard]] vec3 star_minimum(const vertex_star& star, vec3 x, int steps);

/// The worst q of the star's tets with the vertex at x; stops at the first below `enough`.
[[nodiscard]] double star_worst(const vertex_star& star, vec3 x, double enough = 0);

// -- flips ---------------------------------------------------------------------------------------

/// The cotangent weight of edge d-e over the three tets of a bipyramid with rim a, b, c, in m:
/// sum of l cot(theta) / 6 at the rim's edges = -A_d.A_e / (9 V) per tet. The flip of face abc to
/// edge de lowers the harmonic energy exactly when it is positive, the flip back when negative.
/// `scale` receives the sum of the absolute terms, to compare it with. The gain is 9 w |v|^2 / (v_d
/// v_e) with v the affine dependency of the five points.
[[nodiscard]] double flip_weight(const std::array<vec3, 3>& rim, vec3 d, vec3 e, double& scale);

}  // namespace tedit
