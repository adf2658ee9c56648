// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/rounding/round_chains.hpp"

namespace tedit::ops {

struct round_settings {
  double radius = 0;  ///< m.
  int segments = 4;   ///< Facets over an arc of 90 degrees, at least; more where the mesh is finer.
};

/// The rounded surface along one chain: rows of points across the arc, from wall a to wall b.
struct round_strip {
  std::vector<std::vector<std::uint32_t>> rows;  ///< Indices into `round_surface::points`.
};

/// A place where the part changes, for the search of the tets around it.
struct round_reach {
  vec3 from, to;
  double radius = 0;  ///< m; all new points lie within it of the segment.
};

/// All new surface, as points exactly on the rolling ball and triangles outward.
struct round_surface {
  int segments = 0;  ///< Over every arc.
  std::vector<vec3> points;
  std::vector<round_strip> strips;  ///< As the plan's chains.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> chain;  ///< Of each triangle; chains + i for corner i.
  std::vector<round_reach> reach;
  double widest = 0;    ///< m: largest distance of a contact from the edge.
  double arc_step = 0;  ///< m: length of one segment of the arc, mean.
};

/// Places the rounded surface: stations along each chain between its ends, an arc at each, the
/// ball's own octant where three chains meet. Arcs end where they meet the third surface of a
/// corner. Errors: `invalid_argument` naming edge and place where the radius does not fit (beyond a
/// cylinder's own, longer than the edge) or where corners are of a kind that cannot be rounded.
[[nodiscard]] expected<round_surface> make_strips(const mesh_version& mesh, const round_plan& plan,
                                                  const round_settings& settings);

/// "2.5 mm".
[[nodiscard]] std::string length_name(double metres);

}  // namespace tedit::ops
