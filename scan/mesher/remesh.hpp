// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cad/mesher/filling.hpp"
#include "cad/mesher/surface_mesh.hpp"
#include "scan/exchange.hpp"

namespace tedit::scan {

/// How long edges shall be, in mm.
struct edge_lengths {
  std::vector<double> of_solid;  ///< The longest, of each.
  double longest = 0;
  double shortest = 0;  ///< On round faces.
  double thinnest_wall = 0;
  int on_circle = 6;
};

/// By the mean wall of each solid, as for CAD: docs/cad.md, *Sizes*.
[[nodiscard]] edge_lengths lengths_for(const cad::part_facts& facts, const cad::fineness& size);

/// Meshes the surface anew with edges of these lengths: vertices lie on the shapes of their patches
/// and on the lines between those, or else on the file's triangles. Surfaces of the result are
/// places of patches, from 1. `stage` is told how far it is, 0 to 1. Deterministic. Cost: some ten
/// sweeps, each O(n log n).
[[nodiscard]] cad::surface_mesh remesh(const surface_part& part, const edge_lengths& lengths,
                                       const std::function<void(double)>& stage);

}  // namespace tedit::scan
