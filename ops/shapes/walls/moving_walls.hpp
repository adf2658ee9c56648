// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <unordered_map>

#include "mesh/builder.hpp"
#include "mesh/features/wall_shape.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// A surface that moves, as it was before.
struct moving_wall {
  std::optional<wall_shape> exact;
  /// Where there is no exact shape: the unit outward normals at its vertices, one for each side of
  /// a crease within the surface.
  std::unordered_map<vertex_id, std::vector<vec3>> normals;

  [[nodiscard]] bool is(wall_shape::kind kind) const { return exact && exact->type == kind; }

  /// By how much a vertex that is at p now and was at `before` is further out, m: along the mean
  /// of its normals where the surface is of free form.
  [[nodiscard]] double rise(vertex_id v, vec3 before, vec3 p) const;
};

/// Surfaces that move together.
using wall_set = std::map<surface_id, moving_wall>;

/// The planes, round cylinders and cones behind the surfaces, or their normals where they have
/// another form. Errors: `empty_selection` for a surface without an outer side. Cost: O(facet
/// slots).
[[nodiscard]] expected<wall_set> fit_walls(const mesh_version& mesh,
                                           const std::vector<surface_id>& surfaces);

/// Has each cylinder of the set room for its shift before it would be a line? Errors:
/// `invalid_argument` naming one that has not. Cost: O(walls).
[[nodiscard]] expected<void> check_room(const wall_set& walls, double distance);

/// Are all of the surfaces planes? Errors: those of `find_patch`. Cost: O(surfaces x facet slots).
[[nodiscard]] expected<bool> all_flat(const mesh_builder& mesh,
                                      const std::vector<surface_id>& surfaces);

/// What a version has of the shift, as material put on or taken off: mean over the area and
/// furthest from `distance` over the moved surfaces' vertices; for cylinders the change of the
/// radius, fitted anew. Cost: O(facet slots).
[[nodiscard]] std::vector<figure> measure_shift(const mesh_version& base, const mesh_version& after,
                                                const wall_set& walls, double distance);

}  // namespace tedit::ops
