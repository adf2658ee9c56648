// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/vec3.hpp"

namespace tedit::cad {

/// The triangles of all faces of a part; faces between two solids are there once.
struct surface_mesh {
  struct triangle {
    std::array<std::uint32_t, 3> v;
    int surface = 0;
  };

  std::vector<vec3> points;  ///< mm.
  std::vector<triangle> triangles;
};

struct cleaning {
  std::size_t collapsed = 0;
  std::size_t flipped = 0;
  double moved =
    0;  ///< mm: how far a point went, or a triangle's corner was off its edge, at most.
};

/// Mends triangles whose quality (2 r_in / R_circ) is below `flat`, as a mesher of volumes builds
/// tets without volume on them: collapses edges that are shorter than that share of their
/// neighbours, flips or drops what is flat. No edge longer than `most` (mm) is collapsed, and no
/// step moves anything further. Closed surfaces stay closed; a face that is narrower than that may
/// go. Deterministic. Cost: O(n log n).
[[nodiscard]] cleaning clean_surface(surface_mesh& mesh, double most, double flat);

}  // namespace tedit::cad
