// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/execution.hpp"
#include "mesh/builder.hpp"

namespace tedit {

struct smooth_settings {
  int sweeps = 6;              ///< Each goes forward and backward over the vertices.
  double quality_floor = 0.1;  ///< No step may make a tet worse than min(this, the star's worst).
  /// Taubin's pair: the forward half takes +0.5 of the step, the backward half -0.53, so that round
  /// parts do not shrink. Off: both halves take the whole step.
  bool keep_volume = false;
};

struct smooth_report {
  std::size_t movable = 0;      ///< Vertices all of whose facets lie on the surfaces.
  std::size_t moved = 0;        ///< Those that are elsewhere now.
  std::size_t refused = 0;      ///< Steps of which no length was admissible.
  double largest_move = 0;      ///< m, from where the vertex was.
  double roughness_before = 0;  ///< rad: mean angle between neighbouring facets' normals.
  double roughness_after = 0;
};

/// Smooths surfaces: each vertex all of whose boundary facets lie on the given ones goes towards
/// the cotangent-weighted mean of its neighbours on the surface (delta = sum w (x_j - x_i) / sum w,
/// w = (cot alpha + cot beta) / 2, cotangents clamped to those of 3 deg; Nealen et al. 2006), one
/// vertex after the other. All others stay: the rim, interfaces between regions, the interior. A
/// step is at most 0.9 of the one that flattens a tet (volumes are affine in one vertex, so that is
/// exact) and halved, 8 times at most, until no tet around is worse than the floor or the worst
/// before. Changes no topology and no surface id; the volume changes. Deterministic.
/// Errors: `cancelled`; then nothing has changed. Cost: O(facets of the mesh + sweeps * stars).
[[nodiscard]] expected<smooth_report> smooth_surface(mesh_builder& mesh,
                                                     const std::vector<surface_id>& surfaces,
                                                     const smooth_settings& settings,
                                                     const execution& run);

}  // namespace tedit
