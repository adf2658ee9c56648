// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/rounding/round_boundary.hpp"

namespace tedit::ops {

/// The points of a shell under construction: mesh vertices and points of the rounded surface, each
/// once, and points of its own.
class shell_points {
public:
  shell_points(const mesh_version& mesh, const round_surface& made, round_shell& shell)
      : mesh_(mesh), made_(made), shell_(shell), rounded_(made.points.size(), no_id) {}

  std::uint32_t add(vec3 p, vertex_id v = no_id);
  std::uint32_t of_vertex(vertex_id v);
  std::uint32_t of_rounded(std::uint32_t i);

  [[nodiscard]] vec3 operator[](std::uint32_t i) const { return shell_.surface.points[i]; }
  [[nodiscard]] vertex_id vertex(std::uint32_t i) const { return shell_.vertices[i]; }

private:
  const mesh_version& mesh_;
  const round_surface& made_;
  round_shell& shell_;
  std::unordered_map<vertex_id, std::uint32_t> vertices_;
  std::vector<std::uint32_t> rounded_;
};

/// Facets of one wall that hang together inside the cavity and are triangulated anew.
struct wall_piece {
  surface_id surface = 0;
  exact_wall shape;
  std::vector<facet_id> facets;
  std::vector<std::vector<std::uint32_t>> loops;  ///< Its border after the edit, as shell points.
};

/// Finds the walls' pieces that change and their new borders: the rounded surface's along the
/// chains, its arcs where chains end, edges cut or grown at corners. Edges between two pieces get
/// points where they are long beside fine ones; a flat neighbouring wall joins the pieces where its
/// edge is too long for that. `replaced` receives all facets of the pieces. Cost: O(cavity +
/// (points of the borders)^2).
[[nodiscard]] std::vector<wall_piece> find_pieces(const mesh_version& mesh, const round_plan& plan,
                                                  const round_surface& made, const round_cuts& cuts,
                                                  const std::unordered_set<tet_id>& cavity,
                                                  shell_points& points,
                                                  std::unordered_set<facet_id>& replaced);

}  // namespace tedit::ops
