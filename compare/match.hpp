// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <utility>
#include <vector>

#include "base/execution.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// Which vertices, tets and boundary facets two versions have in common. What both have in the same
/// slot is not listed: the lists are as long as the change between versions that stem from each
/// other.
struct version_match {
  /// Vertices of after whose slot before holds no vertex at their place, with the vertex of before
  /// that is there, or `no_id`.
  std::unordered_map<vertex_id, vertex_id> elsewhere;
  std::vector<tet_id> tets_before;  ///< Those that after has not, ascending.
  std::vector<tet_id> tets_after;   ///< Those that before has not, ascending.
  std::vector<facet_id> facets_before;
  std::vector<facet_id> facets_after;
  /// Boundary facets (before, after) that both have, but in other slots or of other surfaces.
  std::vector<std::pair<facet_id, facet_id>> facets_moved;
  std::uint64_t vertices = 0;  ///< In common.

  /// The vertex of before that is where vertex v of after is, or `no_id`.
  [[nodiscard]] vertex_id twin_of(vertex_id v) const {
    const auto found = elsewhere.find(v);
    return found == elsewhere.end() ? v : found->second;
  }
};

/// Vertices are the same when they are at the same place: bit by bit in the same slot, to 1e-12 of
/// the largest coordinate in others (a file in other units rounds). Tets and facets are the same
/// when their corners are. The versions may be of any origin. Errors: `cancelled`. Cost: O(pages)
/// and O(what changed), at most O(mesh).
[[nodiscard]] expected<version_match> match_versions(const mesh_version& before,
                                                     const mesh_version& after,
                                                     const execution& run);

}  // namespace tedit
