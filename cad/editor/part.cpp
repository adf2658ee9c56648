// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/part.hpp"

#include <algorithm>

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

namespace tedit::cad {

std::vector<TopoDS_Face> part_model::faces_of(const std::vector<int>& ids) const {
  std::vector<TopoDS_Face> found;
  for (std::size_t i = 0; i < facts.faces.size(); ++i)
    if (std::ranges::any_of(facts.faces[i].ids,
                            [&](int id) { return std::ranges::find(ids, id) != ids.end(); }))
      found.push_back(TopoDS::Face(faces(static_cast<Standard_Integer>(i + 1))));
  return found;
}

expected<part_model> load_part(const std::filesystem::path& folder) {
  part_model part;
  auto facts = load_facts(folder);
  if (!facts)
    return fail(facts.error());
  part.facts = std::move(*facts);
  BRep_Builder builder;
  if (!BRepTools::Read(part.shape, (folder / shape_file).c_str(), builder) || part.shape.IsNull())
    return fail(ec::internal, "the CAD model that was kept is damaged",
                "Import the CAD file again");
  TopExp::MapShapes(part.shape, TopAbs_FACE, part.faces);
  if (static_cast<std::size_t>(part.faces.Extent()) != part.facts.faces.size())
    return fail(ec::internal, "the CAD model that was kept has other faces than it says",
                "Import the CAD file again");
  return part;
}

bool save_part(const part_model& part, const std::filesystem::path& folder) {
  return BRepTools::Write(part.shape, (folder / shape_file).c_str()) &&
         save_facts(part.facts, folder);
}

TopTools_IndexedDataMapOfShapeListOfShape faces_at_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape result;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, result);
  return result;
}

double volume_below(const TopoDS_Face& face) {
  // Not by BRepGProp::VolumeProperties: it takes a point of each face's own.
  BRepGProp_Face surface(face);
  BRepGProp_Domain outlines(face);
  return BRepGProp_Vinert(surface, outlines, gp_Pnt(0, 0, 0)).Mass();
}

double area_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

gp_Dir outward_of_plane(const TopoDS_Face& face) {
  const auto plane = BRepAdaptor_Surface(face).Plane();
  const auto normal =
    plane.Position().Direct() ? plane.Axis().Direction() : plane.Axis().Direction().Reversed();
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

}  // namespace tedit::cad
