// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "mesh/features/wall_shape.hpp"

namespace tedit {

/// The exact surface behind a wall: a plane, a cylinder, a cone or a sphere.
struct exact_wall {
  wall_shape shape;
  double sphere_radius = 0;  ///< m; 0: no sphere. Its centre is the shape's point.

  [[nodiscard]] bool flat() const {
    return sphere_radius == 0 && shape.type == wall_shape::kind::plane;
  }
  /// Signed, m: of a sphere positive outside.
  [[nodiscard]] double distance(vec3 p) const;
  /// Unit: the gradient of `distance`.
  [[nodiscard]] vec3 normal(vec3 p) const;
  /// m: of the wall's circle at p; that of a plane is infinite.
  [[nodiscard]] double radius_at(vec3 p) const;
};

/// Fitted to all corners of the facets, within 1e-4 of its radius; nothing for free form. Of a wall
/// that goes all the way round no gap between its corners may be as wide as a hexagon's, else no
/// second one as wide as 75 degrees. Cost: O(facets).
[[nodiscard]] std::optional<exact_wall> fit_exact(const mesh_version& mesh,
                                                  std::span<const facet_id> facets);

/// The same for a tool's face, whose triangles are oriented outward. What has fewer than 15 edges a
/// turn is meant as a polygon, unless it is `of_part`. Cost: O(triangles log triangles).
[[nodiscard]] std::optional<exact_wall> fit_exact_tool(
  std::span<const vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
  bool of_part);

}  // namespace tedit
