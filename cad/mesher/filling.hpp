// SPDX-License-Identifier: AGPL-3.0-or-later
// What the programs that mesh with Gmsh have in common.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "cad/exchange.hpp"
#include "cad/mesher/surface_mesh.hpp"
#include "cad/teller.hpp"

namespace tedit::cad {

/// How fine a mesh shall be.
struct fineness {
  double wall_share = 1;  ///< Edge length in terms of the mean wall thickness, 2 V / A of a solid.
  int on_circle = 6;      ///< Edges on a full turn of a round face.
};

/// The one for "coarse", "medium", "fine".
[[nodiscard]] fineness fineness_of(const std::string& name);

/// Round faces are met with edges down to this share of the smallest solid's size: small fillets of
/// a large part have fewer edges on a circle.
inline constexpr double least_share = 0.25;

/// Gmsh's meshes depend on where things lie in memory: the same place each time gives the same
/// mesh. Starts the program anew, in its folder (the first argument, which is "." then), and
/// without variables and a name that differ from shell to shell; call it first.
void lie_still(char** argv);

/// Begins the library, with what it prints going to stdout and one thread: the same mesh each time.
void begin_gmsh();

/// The last error that it said.
[[nodiscard]] std::string last_word_of_gmsh();

/// How a surface is filled: false where it cannot be.
using filler = std::function<bool(const surface_mesh&)>;

/// mm: how far, at most, `fill_mended` would move the surface. Cost: that of mending it.
[[nodiscard]] double moved_by_mending(surface_mesh surface, double wall_mm);

/// Mends what a mesher of volumes makes flat tets on and fills the rest: of one surface or several
/// of the same part the first that can be filled; where none can, the last as it was.
/// `size_mm`: the longest edge that was asked for; `wall_mm`: the thinnest mean wall; `faces`: how
/// many there are. Refuses where none can be filled.
[[nodiscard]] mesh_report fill_mended(std::span<const surface_mesh> ways, double size_mm,
                                      double wall_mm, int faces, const filler& fill,
                                      const teller& tells);

}  // namespace tedit::cad
