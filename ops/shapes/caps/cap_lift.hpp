// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "ops/sdk/operation.hpp"
#include "ops/shapes/caps/quadric.hpp"

namespace tedit::ops {

/// Positions of all points of a plane triangulation in space: the first ones are the `rim`, the
/// others lie where the triangulation has least Dirichlet energy (cotangent weights, five times on
/// the surface found before: nearly the surface of least area). Cost: sparse factors of the size of
/// the cap. Source: algorithms of non-planar holes, steps 3; Pinkall & Polthier 1993.
[[nodiscard]] std::vector<vec3> lift_onto_rim(const planar_filling& filling,
                                              std::span<const vec3> rim);

/// Moves the points behind the rim along `direction` (unit) onto a quadric, plus what the rim
/// itself is off it, carried inwards harmonically. False, with nothing moved, where the quadric is
/// missed or lies further away than `reach` (m).
[[nodiscard]] bool lift_onto_quadric(const planar_filling& filling, const quadric& shape,
                                     vec3 direction, double reach, std::size_t rim_size,
                                     std::vector<vec3>& points);

}  // namespace tedit::ops
