// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "mesh/version.hpp"

namespace tedit::ops {

/// Which facet lies to the left of each directed boundary edge. Cost: O(boundary).
class boundary_edges {
public:
  explicit boundary_edges(const mesh_version& mesh);

  /// The facet with the edge a -> b, or no_id (also where more than one facet claims it).
  [[nodiscard]] facet_id left_of(vertex_id a, vertex_id b) const;

private:
  static std::uint64_t key(vertex_id a, vertex_id b) { return std::uint64_t{a} << 32 | b; }
  std::unordered_map<std::uint64_t, facet_id> facets_;
};

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
/// walk turns inside the selected fan, so that a pinched rim becomes simple loops. Errors:
/// `non_manifold` where an edge has no or several facets behind it.
[[nodiscard]] expected<std::vector<shell>> find_shells(const mesh_version& mesh,
                                                       const boundary_edges& edges,
                                                       const std::vector<facet_id>& selected);

}  // namespace tedit::ops
