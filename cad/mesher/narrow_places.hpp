// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <vector>

#include "mesh/vec3.hpp"

namespace tedit::cad {

/// A place of a face where two of its curves run close to each other, with a size for the edges.
struct narrow_place {
  vec3 at;          ///< mm.
  double size = 0;  ///< mm.
};

/// The narrow places of the current Gmsh model.
struct narrow_places {
  std::vector<narrow_place> all;  ///< Ascending in size.
  std::set<int> curves;           ///< Gmsh's tags of the curves there.
  std::set<int> faces;            ///< And of the faces.

  /// mm: how long edges may be at a place: they grow with how far it is from the narrow ones.
  [[nodiscard]] double size_at(vec3 p) const;
};

/// Looks for strips between two curves of a face that have no end in common, and are nearer to each
/// other than `widest` and no nearer than `thinnest` (both mm): between a hole and the wall's edge,
/// or two holes. A mesh with longer edges there has flat triangles or none. At most `most` places:
/// beyond them nothing is said of any, as then it is no exception but how the part is.
/// Cost: O(segments of the curves' polygons), a face at a time.
[[nodiscard]] narrow_places find_narrow_places(double widest, double thinnest, std::size_t most);

}  // namespace tedit::cad
