// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <span>

#include "mesh/adapt/adapt_mesh.hpp"
#include "mesh/features/wall_shape.hpp"

namespace tedit {

/// The exact walls behind a version's surfaces: planes, cylinders, cones and spheres, each fitted
/// when it is first asked for.
class wall_places {
public:
  explicit wall_places(const mesh_version& mesh) : mesh_(mesh) {}

  /// Where the middle of an edge of the skin belongs: on all the walls whose triangles meet there,
  /// but for those of free form. The middle itself where they are flat or no such point is near.
  /// Cost: a fit of each surface once; else O(walls).
  [[nodiscard]] vec3 middle(vec3 a, vec3 b, std::span<const surface_id> walls);

  /// m: how far a point is off the wall; 0 where that is of free form. Cost: the same.
  [[nodiscard]] double off(surface_id wall, vec3 p);

private:
  /// A wall as its distance and the direction in which that grows.
  struct wall {
    std::optional<wall_shape> shape;
    double sphere_radius = 0;  ///< m; 0: none. Its centre is the shape's point.

    [[nodiscard]] bool known() const { return shape.has_value(); }
    [[nodiscard]] bool flat() const {
      return known() && sphere_radius == 0 && shape->type == wall_shape::kind::plane;
    }
    [[nodiscard]] double distance(vec3 p) const;
    [[nodiscard]] vec3 normal(vec3 p) const;
  };

  const wall& wall_of(surface_id id);
  [[nodiscard]] static wall fitted(const mesh_version& mesh, surface_id id);

  const mesh_version& mesh_;
  std::map<surface_id, wall> walls_;
};

}  // namespace tedit
