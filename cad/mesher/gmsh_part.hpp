// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cad/exchange.hpp"
#include "cad/mesher/filling.hpp"
#include "cad/mesher/narrow_places.hpp"
#include "cad/mesher/surface_mesh.hpp"
#include "cad/teller.hpp"

namespace tedit::cad {

/// A part in Gmsh's library. It is there once in a program.
class gmsh_part {
public:
  /// Loads the BREP of the folder. Refuses when faces and solids are not those of the facts.
  gmsh_part(const program_call& call, const part_facts& facts, const teller& tells);

  /// Meshes curves and faces. Refuses where Gmsh cannot, naming the surface where it is known.
  /// `local`: the longest edges of some faces, mm, and of the curves around them; towards their
  /// neighbours edges grow.
  [[nodiscard]] surface_mesh mesh_faces(const fineness& size, const std::map<int, double>& local);

  /// The same again with short edges in narrow strips of the faces, as between a hole and the edge
  /// of its wall. Nothing where there are none, or many. Call it after `mesh_faces`.
  [[nodiscard]] std::optional<surface_mesh> mesh_faces_finer_where_narrow(
    const std::map<int, double>& local);

  /// From then on sizes are as if narrow strips had not been looked for.
  void forget_narrow_places();

  /// Fills the solids within `faces` with tets and writes all; whether it could.
  [[nodiscard]] bool fill(const surface_mesh& faces);

  /// The largest edge length that was asked for, in mm.
  [[nodiscard]] double size() const { return size_mm_; }
  /// What is short is so in terms of this: the least mean wall thickness of a solid, 2 V / A in mm,
  /// or twice the least local size.
  [[nodiscard]] double least_length() const { return std::min(wall_mm_, 2 * least_local_mm_); }

private:
  void check() const;
  void set_sizes(const fineness& size);
  void set_local_sizes(const std::map<int, double>& local);
  void mesh_narrow_faces();
  [[nodiscard]] surface_mesh meshed_faces() const;
  [[nodiscard]] std::string surface_words(int tag) const;

  const program_call& call_;
  const part_facts& facts_;
  const teller& tells_;
  std::map<int, std::vector<int>> faces_of_;  ///< Of each solid.
  double size_mm_ = 0;
  double wall_mm_ = 0;
  double least_mm_ = 0;  ///< Of all edges that are asked for.
  double least_local_mm_ = HUGE_VAL;
  narrow_places narrow_;
};

}  // namespace tedit::cad
