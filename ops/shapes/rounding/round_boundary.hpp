// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "ops/sdk/operation.hpp"
#include "ops/shapes/rounding/round_strips.hpp"

namespace tedit::ops {

/// How the rounded surface meets the edges between walls that end at a corner: mesh vertices that
/// it swallows, and corners that it leaves standing.
struct round_cuts {
  std::vector<vertex_id> dropped;  ///< Vertices of such edges, and the chains' own.
  /// Corner and the two walls of an edge that grows instead of being cut: the vertex stays.
  std::set<std::tuple<vertex_id, surface_id, surface_id>> grown;
};

/// Errors: `invalid_argument` where an edge is shorter than what the rounding takes of it.
[[nodiscard]] expected<round_cuts> cut_edges(const mesh_version& mesh, const round_plan& plan,
                                             const round_surface& made);

/// The closed surface around the cavity after the edit.
struct round_shell {
  closed_surface surface;
  std::vector<vertex_id> vertices;  ///< Mesh vertex of each point; no_id for new ones.
  std::size_t kept = 0;             ///< Triangles from here on are new boundary.
  /// Of each new triangle: the surface that it belongs to; nothing for the rounded ones.
  std::vector<std::optional<surface_id>> names;
  std::vector<std::size_t> chain;         ///< Of each new triangle without a name.
  std::unordered_set<facet_id> replaced;  ///< Boundary facets that go.
};

/// Puts points into the material behind the rounded surface, one behind each pair of its triangles
/// where there is room: tets there would else have all four corners on it. They join the shell's
/// points. Cost: O(shell x log shell).
void add_depth(const round_surface& made, round_shell& shell);

/// Triangulates the walls' parts inside the cavity anew, up to the rounded surface, and closes the
/// shell. Errors: `invalid_argument` when the rounding leaves a wall (radius too large for it),
/// those of the triangulation. Cost: O(cavity).
[[nodiscard]] expected<round_shell> make_shell(const mesh_version& mesh, const round_plan& plan,
                                               const round_surface& made, const round_cuts& cuts,
                                               const std::unordered_set<tet_id>& cavity,
                                               services& host);

/// Does the new boundary run into what stays of the old one? Errors: `cap_intersects` naming the
/// surface. Cost: O(boundary + (new triangles + boundary near them) x log new triangles), more
/// where many lie at one place.
[[nodiscard]] expected<void> check_free(const mesh_version& mesh, const round_plan& plan,
                                        const round_shell& shell);

}  // namespace tedit::ops
