// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/execution.hpp"
#include "mesh/level_set.hpp"
#include "mesh/level_set_patch.hpp"

namespace tedit::ops {

/// The material between a flat surface and the plane at a depth below it. Where the surface's
/// border is convex the slab runs on through the neighbours, which are trimmed; where a neighbour
/// rises beside it (the wall of a pocket, a rib on a plate) or goes straight down, the slab ends
/// below the border, as if the wall went on downwards.
class slab {
public:
  slab(mesh_builder& mesh, surface_patch patch, double depth);

  /// Splits tets so that each lies inside or outside: along the walls first, then along the floor.
  /// Errors: those of `split_at_level`.
  [[nodiscard]] expected<void> cut(const execution& run);

  /// The tets of the slab. Errors: `invalid_argument` naming the wall's thickness when it is not
  /// more than the depth, or the surface into which the cut would run.
  [[nodiscard]] expected<std::unordered_set<tet_id>> tets() const;

  /// Does the face lie on the floor?
  [[nodiscard]] bool on_floor(const std::array<vertex_id, 3>& face) const;

  /// The wall that the face lies on, or null.
  [[nodiscard]] const patch_wall* wall_of(const std::array<vertex_id, 3>& face) const;

  [[nodiscard]] const surface_patch& patch() const { return patch_; }

private:
  /// Distance above the floor's plane is negative: depth - depth of the vertex, with a zero.
  [[nodiscard]] double below_floor(vertex_id v) const;
  [[nodiscard]] bool meets(const patch_wall& wall, tet_id t) const;
  [[nodiscard]] std::vector<tet_id> tets_at(const patch_wall& wall) const;
  [[nodiscard]] std::unordered_set<tet_id> flood(bool also_crossed) const;
  [[nodiscard]] expected<void> check(const std::unordered_set<tet_id>& inside) const;

  mesh_builder& mesh_;
  surface_patch patch_;
  double depth_;
  double zero_;  ///< Distances up to this are rounding, m.
  std::vector<patch_wall> walls_;
  std::vector<std::unordered_set<vertex_id>> sheets_;  ///< Vertices on each wall's plane.
};

}  // namespace tedit::ops
