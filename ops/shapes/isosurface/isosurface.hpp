// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/box.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// A field at a point: below 0 is inside.
struct field_sample {
  double value = 0;  ///< m.
  vec3 gradient;     ///< Where `value` grows; unit, but for creases of the field.
};

/// Whose value changes by at most as much as the place, such as a distance.
using distance_field = std::function<field_sample(vec3)>;

struct isosurface_settings {
  box extent;       ///< All of the inside lies in it.
  double cell = 0;  ///< m: what is thinner than this may be lost.
  vec3 shift;  ///< Of the grid, in cells: another one where a surface came out that is not clean.
  std::size_t most_cells = 400'000;  ///< Through which the surface runs.
};

/// What `isosurface` gives.
struct contoured_surface {
  closed_surface surface;
  /// For each point the middle of where the surface crosses its cell: a safer place, that knows no
  /// creases.
  std::vector<vec3> middles;
};

/// The closed surface around the inside, with its edges and corners where the field has creases;
/// each piece of it is a manifold. Flat faces lie in their planes to rounding. Where creases come
/// closer to each other than a cell it may pass through itself. Errors:
/// `invalid_parameter` where more cells would be needed, `cancelled`. Cost: O(cells that the
/// surface runs through), some ten samples each. Source: Ju et al., "Dual contouring of Hermite
/// data", 2002; a vertex for each piece of the surface in a cell: Nielson, "Dual marching cubes",
/// 2004.
[[nodiscard]] expected<contoured_surface> isosurface(const distance_field& field,
                                                     const isosurface_settings& settings,
                                                     const execution& run);

}  // namespace tedit::ops
