// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/features/rims.hpp"

namespace tedit::ops {

/// A run of rim edges whose far sides lie in one plane.
struct rim_plane {
  std::size_t first = 0;  ///< Edge of the rim, and the vertex it starts at.
  std::size_t edges = 0;
  vec3 point;
  vec3 normal;  ///< Unit, outward.
};

/// The two or three planes that surround a rim which runs over an edge or a corner of the part,
/// each by one run of edges, in the rim's order; empty when the surroundings are anything else.
[[nodiscard]] std::vector<rim_plane> rim_planes(const mesh_version& mesh, const rim& r);

/// The point of three planes; nothing when two are nearly parallel.
[[nodiscard]] std::optional<vec3> common_point(const std::vector<rim_plane>& planes);

}  // namespace tedit::ops
