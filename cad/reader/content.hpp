// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>

#include "cad/exchange.hpp"
#include "cad/teller.hpp"
#include "mesh/types.hpp"

namespace tedit::cad {

/// A solid where it stands in the part, in mm.
struct placed_solid {
  TopoDS_Shape shape;
  std::string name;
  std::optional<colour> looks;
};

/// By shapes without their place: what is used twice has one entry.
using names_of_shapes = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;
using ids_of_shapes = NCollection_DataMap<TopoDS_Shape, std::vector<int>, TopTools_ShapeMapHasher>;
using colours_of_shapes = NCollection_DataMap<TopoDS_Shape, colour, TopTools_ShapeMapHasher>;

/// What a CAD file holds.
struct cad_content {
  std::string length_unit = "mm";
  std::vector<placed_solid> solids;
  std::vector<TopoDS_Shape> loose;  ///< Roots with faces that belong to no solid.
  names_of_shapes names;
  colours_of_shapes colours;
  ids_of_shapes ids;     ///< Of faces, where TEdit has written the file.
  bool is_sewn = false;  ///< The solids were made of those faces.
  std::vector<std::string> notices;

  [[nodiscard]] const std::string* name_of(const TopoDS_Shape& shape) const;
  [[nodiscard]] const colour* colour_of(const TopoDS_Shape& shape) const;
  [[nodiscard]] const std::vector<int>* ids_of(const TopoDS_Shape& shape) const;

  /// What is known of a face is known of what became of it, too.
  void carry_over(const TopoDS_Shape& face, const TopoDS_Shape& image);
};

/// Reads a STEP, IGES or BREP file. Refuses one that it cannot.
[[nodiscard]] cad_content read_step(const std::string& file, const teller& tells);
[[nodiscard]] cad_content read_iges(const std::string& file, const teller& tells);
[[nodiscard]] cad_content read_brep(const std::string& file, const teller& tells);

/// Makes solids of loose faces that close a volume, where there is no solid.
void sew_loose_faces(cad_content& content, const teller& tells);

/// Takes edges out that are shorter than a millionth of their solid, where its faces stay as they
/// are otherwise; a notice says so. Cost: O(edges).
void close_up_edges(cad_content& content, const teller& tells);

/// The solids with common faces where they touch, and the facts of both in the order in which a
/// mesher numbers them.
struct joined_part {
  TopoDS_Shape shape;
  part_facts facts;
  std::vector<surface_geometry> geometries;  ///< Of each face.
};
[[nodiscard]] joined_part join_solids(const cad_content& content, const teller& tells);

}  // namespace tedit::cad
