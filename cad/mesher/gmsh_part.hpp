// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "cad/exchange.hpp"
#include "cad/mesher/filling.hpp"
#include "cad/mesher/surface_mesh.hpp"
#include "cad/teller.hpp"

namespace tedit::cad {

/// A part in Gmsh's library. It is there once in a program.
class gmsh_part {
public:
  /// Loads the BREP of the folder. Refuses when faces and solids are not those of the facts.
  gmsh_part(const program_call& call, const part_facts& facts, const teller& tells);

  /// Meshes curves and faces. Refuses where Gmsh cannot, naming the surface where it is known.
  [[nodiscard]] surface_mesh mesh_faces(const fineness& size);

  /// Fills the solids within `faces` with tets and writes all; whether it could.
  [[nodiscard]] bool fill(const surface_mesh& faces);

  /// The largest edge length that was asked for, in mm.
  [[nodiscard]] double size() const { return size_mm_; }
  /// The least mean wall thickness of a solid, 2 V / A in mm.
  [[nodiscard]] double thinnest_wall() const { return wall_mm_; }

private:
  void check() const;
  void set_sizes(const fineness& size);
  [[nodiscard]] std::string surface_words(int tag) const;

  const program_call& call_;
  const part_facts& facts_;
  const teller& tells_;
  std::map<int, std::vector<int>> faces_of_;  ///< Of each solid.
  double size_mm_ = 0;
  double wall_mm_ = 0;
};

}  // namespace tedit::cad
