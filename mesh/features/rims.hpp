// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// The boundary facet across the edge from `v[edge]` to `v[edge + 1]` of facet f, found by turning
/// around the edge through the material. Cost: O(tets at the edge).
[[nodiscard]] facet_id facet_across(const mesh_version& mesh, facet_id f, int edge);

/// Angle through the material at edge `edge` of a boundary facet, rad: 90 degrees at the edge of a
/// box, 180 on a smooth surface, 270 at the flat bottom of a drilled hole.
[[nodiscard]] double material_angle(const mesh_version& mesh, facet_id f, int edge);

/// A closed loop of edges between selected and unselected facets.
struct rim {
  std::vector<vertex_id> loop;  ///< In the direction of the selected facets' edges.
  std::vector<facet_id> inner;  ///< Selected facet at edge i (loop[i] to loop[i+1]).
  std::vector<facet_id> outer;  ///< Unselected facet across edge i.
  vec3 centre;
  vec3 normal;               ///< Newell normal, unit: points out of the plug.
  double radius = 0;         ///< Largest distance of a rim vertex from the centre, m.
  double mean_edge = 0;      ///< m.
  double deviation = 0;      ///< Largest distance from the Newell plane, m.
  double concave_share = 0;  ///< Share of the rim's length with a material angle >= 179 degrees.
  double convex_share = 0;   ///< The same with at most 181 degrees; smooth edges count for both.

  /// Within max(1e-4 edge, 1e-4 radius) of a plane.
  [[nodiscard]] bool planar() const { return deviation <= 1e-4 * std::max(mean_edge, radius); }

  /// "the rim at (..) mm with radius .. mm".
  [[nodiscard]] std::string name() const;
};

/// The selected facets that hang together over edges, with their rims.
struct shell {
  std::vector<facet_id> facets;
  std::vector<rim> rims;
};

/// Splits a selection into shells and walks their rims: at a vertex where several rims meet, the
/// walk turns inside the selected fan, so that a pinched rim becomes simple loops.
/// Cost: O(selection).
[[nodiscard]] std::vector<shell> find_shells(const mesh_version& mesh,
                                             const std::vector<facet_id>& selected);

}  // namespace tedit
