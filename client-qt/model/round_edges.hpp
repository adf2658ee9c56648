// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit::desktop {

/// An edge between two triangles; the lower vertex first.
using mesh_edge = std::pair<vertex_id, vertex_id>;

/// Vertices of each chain of edges, in order; a closed one begins and ends with the same.
/// Cost: O(edges log edges).
[[nodiscard]] std::vector<std::vector<vertex_id>> chains_of(const std::vector<mesh_edge>& edges);

/// An arc or a circle.
struct round_edge {
  vec3 middle;  ///< m.
  vec3 axis;    ///< Unit, across its plane; either way.
  double radius = 0;
};

/// The arc that a chain of points is: of at least 80 degrees and four edges, flat and round to 1 %
/// of its radius, no edge of which turns by more than 75 degrees, so that a bore of six edges is
/// round and a square is not. Nothing else. Cost: O(points).
[[nodiscard]] std::optional<round_edge> round_edge_of(const std::vector<vec3>& chain);

}  // namespace tedit::desktop
