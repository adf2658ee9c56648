// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/box.hpp"
#include "mesh/version.hpp"

namespace tedit::ops {

/// Where a wall ends at the face between its region and another one.
struct bonded_border {
  vec3 into;        ///< Unit, along that face, square to the edge.
  double room = 0;  ///< m: how thick the other region is behind it.
};

/// What lies at an edge of facet f in the part; nothing where no other region does. Cost: O(tets at
/// the edge, and along a ray through the other region).
[[nodiscard]] std::optional<bonded_border> bonded_border_at(const mesh_version& mesh, facet_id f,
                                                            int edge);

using bond_triangle = std::array<vec3, 3>;

/// Faces between regions that meet a box. Cost: O(interface facets).
[[nodiscard]] std::vector<bond_triangle> bonds_in(const mesh_version& mesh, const box& where);

/// How far such faces come out over the edge a b, m, seen against `down` (unit, square to the edge,
/// to the right of which they are), as deep below it as `depth`: a round face does between the
/// corners of its border.
[[nodiscard]] double bulge_over(const std::vector<bond_triangle>& bonds, vec3 a, vec3 b, vec3 down,
                                double depth);

}  // namespace tedit::ops
