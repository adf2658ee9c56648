// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// Edges of the mesh in a row between two surfaces, and the line or circle that they lie on.
struct edge_curve {
  enum class kind { straight, arc, other };

  kind type = kind::other;
  std::vector<vec3> points;  ///< m, in order; a closed one ends before its first point.
  bool closed = false;
  vec3 middle;        ///< m: of an arc its circle's centre, else half of the length along it.
  vec3 direction;     ///< Unit: along a straight one, across the plane of an arc; of others 0.
  double radius = 0;  ///< m; of an arc.
  double length = 0;  ///< m.
};

/// All that facets of both surfaces have in common: one for each row of edges, which ends where it
/// branches. Straight: to 1e-4 of the length. An arc: to 1 % of its radius, of 80 degrees at least,
/// with no corner sharper than 75 degrees; a coarse bore of six edges is round, a square is not.
/// Cost: O(facets of the first surface).
[[nodiscard]] std::vector<edge_curve> edges_between(const mesh_version& mesh, surface_id first,
                                                    surface_id second);

/// A unit or its opposite: the one whose largest component is positive, so that an axis without a
/// sense of its own has one.
[[nodiscard]] vec3 upright(vec3 unit);

}  // namespace tedit
