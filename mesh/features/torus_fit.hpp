// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/features/round_fit.hpp"

namespace tedit {

/// What a circle sweeps that turns around an axis in its plane, as fillets at round edges are.
struct torus {
  vec3 centre;
  vec3 axis;               ///< Unit.
  double radius = 0;       ///< m: of the circle that the tube's middle runs along.
  double tube_radius = 0;  ///< m
};

/// The torus that all corners lie on within 1e-4 of the tube's radius, fitted to what most of them
/// say; nothing for others, for fewer than ten corners or three rows of them around the tube (any
/// wall that was turned would fit), and where rows are more than 55 degrees apart. Each of sixty
/// directions is tried as that of the axis: the line that the triangles' normals come nearest to,
/// by their linear complex (Pottmann and Randrup 1998), and a circle through the corners. From the
/// best eight all seven numbers come by Levenberg and Marquardt's method on the distances. Cost:
/// O(corners) some times; free form is told by 80 of them.
[[nodiscard]] std::optional<torus> fit_torus(const facet_corners& wall);

}  // namespace tedit
