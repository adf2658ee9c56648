// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <unordered_map>
#include <unordered_set>

#include "base/execution.hpp"
#include "mesh/builder.hpp"

namespace tedit {

struct level_set_settings {
  /// A vertex nearer to the level than this share of a crossed edge is moved onto it, where the
  /// part allows that: cuts beside a vertex make slivers. At most 0.5.
  double snap = 0.2;
  /// Moving a vertex must not bring a tet's q below min(floor, what its star had).
  double floor = 0.1;
  /// Values up to this size count as zero; the vertex stays where it is. In the function's unit.
  double zero = 0;
  /// The function behind the values, for one that is not linear: cut points are then looked for
  /// along their edge until it vanishes there. May be empty.
  std::function<double(vec3)> exact;
  /// Vertices of earlier levels: one that lies on such a sheet moves only within it.
  std::vector<const std::unordered_set<vertex_id>*> sheets;
};

/// What a cut left behind.
struct level_set_cut {
  std::unordered_set<vertex_id> on_level;        ///< Vertices whose value is now zero.
  std::unordered_map<vertex_id, double> values;  ///< Of all vertices of the region; 0 on the level.
  std::size_t splits = 0;
  std::size_t snaps = 0;
};

/// Splits tets along the zero level of a function that is linear in each tet, so that afterwards no
/// edge of the region has ends of both signs. Every crossed edge gets a vertex where the level
/// crosses it, the longest first (ties by vertex ids): neighbours split their common face alike, so
/// the mesh stays conforming also beyond the region, whose tets around crossed edges are split,
/// too. Boundary facets keep their surfaces, interface facets and tets their regions; geometry and
/// volume stay, but for rounding.
/// @param region the tets in which the level counts; `value` is asked once for each corner.
/// Errors: `degenerate_tet` where a tet is too flat to be split, `cancelled`; the builder is then
/// half changed and to be thrown away. Cost: O(region + stars of crossed edges).
[[nodiscard]] expected<level_set_cut> split_at_level(mesh_builder& mesh,
                                                     const std::vector<tet_id>& region,
                                                     const std::function<double(vertex_id)>& value,
                                                     const level_set_settings& settings,
                                                     const execution& run);

/// Splits the edge a-b at a new vertex: every tet around it becomes two, boundary and interface
/// facets likewise. Errors: `degenerate_tet`; then nothing has changed but for a loose vertex.
[[nodiscard]] expected<vertex_id> split_edge(mesh_builder& mesh, vertex_id a, vertex_id b, vec3 at);

}  // namespace tedit
