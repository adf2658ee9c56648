// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include "mesh/builder.hpp"

namespace tedit {

/// Local changes that raise the worst quality of the tets they replace; each either improves or
/// leaves the mesh alone. None moves a boundary vertex, changes a facet or crosses regions.
class local_moves {
public:
  /// Only tets of `allowed` are replaced; new ones join the set.
  local_moves(mesh_builder& mesh, std::unordered_set<tet_id> allowed)
      : mesh_(mesh), allowed_(std::move(allowed)) {}

  [[nodiscard]] const std::unordered_set<tet_id>& allowed() const { return allowed_; }

  /// The best 2-3 flip of a face or removal of an edge (3-2, 4-4, 5-6, 6-8, 7-10) of tet t.
  bool flip(tet_id t);

  /// Moves one interior corner of t to where the worst tet around it is best.
  bool relocate_corner(tet_id t);

  /// Splits an interior edge of t and moves the new vertex to where the worst tet is best.
  bool insert_vertex(tet_id t);

private:
  struct proposal {
    std::vector<tet_id> removed;
    std::vector<tet> added;
    double worst = 0;  ///< Of the added tets.
  };

  /// The tets around an interior edge in cyclic order with their link vertices, or nothing when the
  /// edge is on the boundary, between regions or leaves the allowed set.
  struct edge_ring {
    std::vector<tet_id> tets;
    std::vector<vertex_id> link;
  };
  [[nodiscard]] std::optional<edge_ring> interior_ring(vertex_id a, vertex_id b) const;

  [[nodiscard]] std::optional<proposal> face_flip(tet_id t, int face) const;
  [[nodiscard]] std::optional<proposal> edge_removal(vertex_id a, vertex_id b) const;
  [[nodiscard]] double worst(const std::vector<tet_id>& tets) const;
  [[nodiscard]] double quality(const tet& t) const;
  [[nodiscard]] bool positive(const tet& t) const;
  bool apply(const proposal& change);

  /// The star of a vertex that may move: interior, one region, all allowed; else empty.
  [[nodiscard]] std::vector<tet_id> movable_star(vertex_id v) const;
  [[nodiscard]] double worst_with(const std::vector<tet_id>& star, vertex_id v, vec3 at) const;
  bool relocate(vertex_id v);

  mesh_builder& mesh_;
  std::unordered_set<tet_id> allowed_;
};

}  // namespace tedit
