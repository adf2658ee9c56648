// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "ops/fill_hole/rims.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// One flat cap: triangles over rim vertices and new points.
struct cap {
  vec3 normal;                                          ///< Unit, out of the plug.
  std::vector<std::size_t> rims;                        ///< Rims of the shell that bound it.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Indices into `plug_surface::points`.
};

/// The closed surface of a plug: the shell turned inside out, and the caps.
struct plug_surface {
  closed_surface surface;           ///< Shell triangles first, then the caps'.
  std::vector<vertex_id> vertices;  ///< Mesh vertex of each point; no_id for cap points.
  std::size_t shell_triangles = 0;
  std::vector<cap> caps;
  double volume = 0;  ///< Divergence integral, m^3.
};

/// Closes a shell: one cap for each connected area of a group of coplanar rims (even-odd, so nested
/// rims give a ring), with interior points at `spacing_factor` times the rims' mean edge. Errors:
/// `non_planar_rim` naming the rim; those of the triangulation.
[[nodiscard]] expected<plug_surface> close_shell(const mesh_version& mesh, const shell& part,
                                                 double spacing_factor, services& host);

}  // namespace tedit::ops
