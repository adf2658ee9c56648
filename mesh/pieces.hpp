// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <unordered_set>

#include "mesh/builder.hpp"

namespace tedit {

// What operations that take tets off need to know before they do it: whether the rest stays a clean
// solid in one piece. `removed` is always the set of tets that are to go.

/// Puts tets back until the boundary of what is left is a 2-manifold wherever it was one before: at
/// an edge with more than two facets all removed tets around it return, at a vertex with more than
/// one fan likewise. Always ends, at the latest with nothing removed. Returns the number of edges
/// and vertices mended. Cost: O(stars of the removed tets' vertices).
std::size_t mend_hinges(const mesh_builder& mesh, std::unordered_set<tet_id>& removed);

/// A part of a body that the removal cuts off from the rest of it.
struct loose_piece {
  std::vector<tet_id> tets;
  double volume = 0;  ///< m^3.
  vec3 centre;        ///< Volume centroid.
};

/// What the removal leaves of each body it touches. Tets hang together over faces.
struct remaining_body {
  double volume_before = 0;         ///< m^3.
  std::vector<loose_piece> pieces;  ///< Largest first; none: the body would vanish.
};

/// Cost: O(bodies that are touched).
[[nodiscard]] std::vector<remaining_body> remaining_bodies(
  const mesh_builder& mesh, const std::unordered_set<tet_id>& removed);

/// What becomes of a body that falls apart.
enum class piece_policy {
  refuse,
  keep_largest,  ///< The other pieces go, too.
  allow          ///< All stay but crumbs.
};

/// What came of a removal that is ready to be applied.
struct removal_report {
  std::size_t hinges_mended = 0;
  std::size_t crumbs = 0;     ///< Pieces under 1 % of their body that were removed with the rest.
  double crumb_volume = 0;    ///< m^3.
  std::size_t bodies = 0;     ///< Touched.
  std::size_t pieces = 0;     ///< What they fall into.
  std::size_t dropped = 0;    ///< Larger pieces that were removed, too (`keep_largest`).
  double dropped_volume = 0;  ///< m^3.
};

/// Mends hinges, removes crumbs and refuses what would vanish or, unless the policy says otherwise,
/// fall apart. Errors: `empty_selection` when all tets had to return or a body would vanish,
/// `invalid_argument` naming the volumes of the pieces. Cost: as above.
[[nodiscard]] expected<removal_report> settle_removal(const mesh_builder& mesh,
                                                      std::unordered_set<tet_id>& removed,
                                                      piece_policy policy = piece_policy::refuse);

/// The change of a version's volume by the divergence of its boundary alone, m^3: the facets that
/// are new or moved less those that were there, so it is independent of the tets. Both share slots.
/// Cost: O(facet slots).
[[nodiscard]] double boundary_volume_change(const mesh_version& before, const mesh_version& after);

/// The interface facets whose tets are gone on one side or both leave the list.
/// Cost: O(interfaces + stars), nothing for a part without any.
void drop_bare_interfaces(mesh_builder& mesh);

}  // namespace tedit
