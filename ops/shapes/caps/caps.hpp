// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include "mesh/features/rims.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// One piece of the surface that closes a rim: triangles over rim vertices and new points.
struct cap {
  std::vector<facet_id> outer;  ///< Boundary facets across the rim edges that bound it.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Indices into `plug_surface::points`.
  /// The surface that this cap goes on: the only one around it, and the cap lies in its plane or on
  /// the quadric fitted to it.
  std::optional<surface_id> continues;
};

/// The closed surface of a plug: the shell turned inside out, and the caps.
struct plug_surface {
  closed_surface surface;           ///< Shell triangles first, then the caps'.
  std::vector<vertex_id> vertices;  ///< Mesh vertex of each point; no_id for cap points.
  std::size_t shell_triangles = 0;
  std::vector<cap> caps;
  double volume = 0;  ///< Divergence integral, m^3.
};

/// Closes a shell, with interior points at `spacing_factor` times the rims' mean edge:
/// - flat rims: one cap for each connected area of a group of coplanar rims (even-odd, so nested
///   rims give a ring);
/// - a rim over the edge between two flat surfaces, or over the corner of three: one flat cap in
///   each of their planes;
/// - any other rim: a quadric fitted to its surroundings where they lie on one (a hole through a
///   cylinder's wall), else the surface of least area over the rim (cotangent weights).
/// Errors: `non_planar_rim` naming a rim whose projection crosses itself; those of the
/// triangulation. Source: the paper, 5.1; Brunton et al. 2009 for the unfolding.
[[nodiscard]] expected<plug_surface> close_shell(const mesh_version& mesh, const shell& part,
                                                 double spacing_factor, services& host);

/// The corners of the given boundary facets and of about two rings around them, without what lies
/// behind facets of `barred`; in the order of their ids. Cost: O(rings).
[[nodiscard]] std::vector<vec3> surrounding_points(const mesh_version& mesh,
                                                   const std::vector<facet_id>& facets,
                                                   const std::unordered_set<facet_id>& barred);

}  // namespace tedit::ops
