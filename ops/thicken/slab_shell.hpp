// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>

#include "mesh/level_set_patch.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The closed surface around a slab that grows on a flat patch: the facets it covers turned round,
/// the sides, the cap.
struct slab_shell {
  closed_surface surface;           ///< Covered facets first, then sides, then the cap.
  std::vector<vertex_id> vertices;  ///< Mesh vertex of each point; no_id for new ones.
  std::vector<facet_id> covered;
  std::vector<facet_id> neighbour;  ///< For each side triangle the facet beside the patch below it.
  std::size_t cap_first = 0;        ///< Index of the cap's first triangle.
};

/// Splits the neighbours that rise beside the patch at the height, so that they can be covered up
/// to there. Errors: those of `split_at_level`.
[[nodiscard]] expected<void> split_rising_neighbours(mesh_builder& mesh, const surface_patch& patch,
                                                     double height, const execution& run);

/// Errors: `cap_intersects` under a roof, `not_a_hole` when the sides do not close, those of the
/// triangulation.
[[nodiscard]] expected<slab_shell> make_slab_shell(const mesh_builder& mesh,
                                                   const surface_patch& patch, double height,
                                                   services& host);

/// Does anything of the boundary stand where the slab's sides and cap would be? Errors:
/// `cap_intersects` naming the surface. Cost: O(boundary), each facet as
/// `new_triangles::meet`.
[[nodiscard]] expected<void> check_free(const mesh_builder& mesh, const slab_shell& shell);

}  // namespace tedit::ops
