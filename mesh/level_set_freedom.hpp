// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/builder.hpp"

namespace tedit {

/// Where a vertex may go without changing the part: anywhere inside it (3), in its flat surface
/// (2), along the straight edge between two flat surfaces (1), nowhere (0). Vertices between
/// regions stay.
struct vertex_freedom {
  int dimensions = 0;
  vec3 axis;  ///< Unit: the surface's normal (2), the edge's direction (1).

  /// Does a step leave every surface around the vertex as it is?
  [[nodiscard]] bool allows(vec3 step) const;

  /// The part of a step that does.
  [[nodiscard]] vec3 project(vec3 step) const;
};

/// Surfaces count as flat, edges as straight, within 1e-6 of the facets' size. Cost: O(star).
[[nodiscard]] vertex_freedom freedom_of(const mesh_builder& mesh, vertex_id v,
                                        const std::vector<tet_id>& star);

/// May a vertex be drawn to a neighbour on the boundary? Both must lie on the same surface or on
/// the same edge between two; flat surfaces stay flat, curved ones within `tolerance` (share of the
/// longest boundary edge at the vertex) of where they were, and no facet turns by more than 45
/// degrees. Meant for vertices without `freedom_of` that a cut put close together. Cost: O(stars).
[[nodiscard]] bool may_merge(const mesh_builder& mesh, vertex_id from, vertex_id to,
                             const std::vector<tet_id>& star, double tolerance);

/// The boundary facets that touch a vertex, out of its star.
[[nodiscard]] std::vector<facet_id> facets_at(const mesh_builder& mesh, vertex_id v,
                                              const std::vector<tet_id>& star);

}  // namespace tedit
