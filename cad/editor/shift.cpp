// SPDX-License-Identifier: AGPL-3.0-or-later
// Walls that move, and edges that are rounded.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffset_MakeSimpleOffset.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "cad/editor/in_place.hpp"
#include "cad/editor/slab.hpp"
#include "cad/editor/ways.hpp"

namespace tedit::cad {

namespace {

bool is_flat(const TopoDS_Face& face) {
  return BRepAdaptor_Surface(face).GetType() == GeomAbs_Plane;
}

/// The face where it is in the part: oriented as its solid has it.
std::vector<TopoDS_Face> oriented_faces(const part_model& part, const std::vector<int>& ids) {
  TopTools_MapOfShape wanted;
  for (const auto& face : part.faces_of(ids))
    wanted.Add(face);
  std::vector<TopoDS_Face> found;
  for (TopExp_Explorer all(part.shape, TopAbs_FACE); all.More(); all.Next())
    if (wanted.Contains(all.Current()))
      found.push_back(TopoDS::Face(all.Current()));
  return found;
}

/// What lies between a face and the same face moved along its normals.
TopoDS_Shape layer_of(const TopoDS_Face& face, double distance) {
  if (is_flat(face))
    return BRepPrimAPI_MakePrism(face, gp_Vec(outward_of_plane(face)) * distance).Shape();
  BRepOffset_MakeSimpleOffset offset(face, distance);
  offset.SetBuildSolidFlag(Standard_True);
  offset.Perform();
  return offset.IsDone() ? offset.GetResultShape() : TopoDS_Shape();
}

/// Does the solid own one of the faces?
std::function<bool(const TopoDS_Shape&)> owner_of(const std::vector<TopoDS_Face>& faces) {
  return [&faces](const TopoDS_Shape& solid) {
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(solid, TopAbs_FACE, own);
    return std::ranges::any_of(faces, [&](const TopoDS_Face& one) { return own.Contains(one); });
  };
}

TopoDS_Shape moved_by_layers(const part_model& part, const std::vector<TopoDS_Face>& walls,
                             double distance) {
  std::vector<TopoDS_Shape> layers;
  for (const auto& wall : walls) {
    const auto layer = layer_of(wall, distance);
    if (layer.IsNull())
      return {};
    layers.push_back(layer);
  }
  return combined(part, layers, distance > 0 ? body_operation::add : body_operation::cut,
                  owner_of(walls), new_edges::go_across_simple);
}

/// Its direction as the face goes round it, at its middle.
struct edge_middle {
  gp_Pnt at;
  gp_Vec along;
};

edge_middle middle_of(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  edge_middle result;
  curve.D1((curve.FirstParameter() + curve.LastParameter()) / 2, result.at, result.along);
  if (edge.Orientation() == TopAbs_REVERSED)
    result.along.Reverse();
  return result;
}

gp_Vec outward_at(const TopoDS_Face& face, const TopoDS_Edge& edge) {
  Standard_Real first = 0;
  Standard_Real last = 0;
  const auto curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull())
    return {};
  const auto uv = curve->Value((first + last) / 2);
  gp_Pnt point;
  gp_Vec u;
  gp_Vec v;
  BRepAdaptor_Surface(face).D1(uv.X(), uv.Y(), point, u, v);
  const auto normal = u.Crossed(v);
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

/// 1: an outer edge, -1: an inner one, 0: the faces run on smoothly.
int bend_at(const TopoDS_Face& one, const TopoDS_Face& other, const TopoDS_Edge& edge) {
  for (TopExp_Explorer all(one, TopAbs_EDGE); all.More(); all.Next()) {
    if (!all.Current().IsSame(edge))
      continue;
    const auto own = TopoDS::Edge(all.Current());
    const auto n = outward_at(one, own);
    const auto m = outward_at(other, own);
    if (n.Magnitude() < 1e-12 || m.Magnitude() < 1e-12)
      return 0;
    const auto into = n.Normalized().Crossed(middle_of(own).along.Normalized());
    const double bend = m.Normalized().Dot(into);
    constexpr double smooth = 1e-3;
    return bend < -smooth ? 1 : bend > smooth ? -1 : 0;
  }
  return 0;
}

TopoDS_Shape rounded(const part_model& part, const std::vector<TopoDS_Face>& walls,
                     const cad_step& step) {
  TopTools_MapOfShape picked;
  for (const auto& wall : walls)
    picked.Add(wall);
  const auto at = faces_at_edges(part.shape);
  BRepFilletAPI_MakeFillet fillet(part.shape);
  for (Standard_Integer i = 1; i <= at.Extent(); ++i) {
    const auto& around = at(i);
    if (around.Extent() != 2)
      continue;
    const bool both = picked.Contains(around.First()) && picked.Contains(around.Last());
    const bool one = picked.Contains(around.First()) || picked.Contains(around.Last());
    if (step.surfaces.size() > 1 ? !both : !one)
      continue;
    const auto edge = TopoDS::Edge(at.FindKey(i));
    const int wanted = step.convex ? 1 : -1;
    if (bend_at(TopoDS::Face(around.First()), TopoDS::Face(around.Last()), edge) == wanted)
      fillet.Add(step.distance_mm, edge);
  }
  if (fillet.NbContours() == 0)
    return {};
  fillet.Build();
  return fillet.IsDone() ? fillet.Shape() : TopoDS_Shape();
}

}  // namespace

std::vector<way> ways_to_shift(const part_model& part, const cad_step& step,
                               const edited_surface& mesh) {
  const auto walls =
    std::make_shared<std::vector<TopoDS_Face>>(oriented_faces(part, step.surfaces));
  if (walls->empty())
    return {};
  const double distance = step.distance_mm;
  std::vector<way> ways{
    {"in place", [&part, &step] { return moved_in_place(part, step); }},
    {"layer", [&part, walls, distance] { return moved_by_layers(part, *walls, distance); }}};
  if (!std::ranges::all_of(*walls, is_flat))
    return ways;
  for (const auto& [name, by] : {std::pair{"slab", slab_division::edges},
                                 {"slab by edges around", slab_division::edges_around},
                                 {"slab by planes around", slab_division::planes_around},
                                 {"slab by edges beyond", slab_division::edges_beyond}})
    ways.push_back({name, [&part, &mesh, walls, distance, by] {
                      return moved_by_slab(part, *walls, distance, by, mesh);
                    }});
  return ways;
}

std::vector<way> ways_to_round(const part_model& part, const cad_step& step) {
  const auto walls =
    std::make_shared<std::vector<TopoDS_Face>>(oriented_faces(part, step.surfaces));
  return {{"fillet", [&part, walls, &step] { return rounded(part, *walls, step); }}};
}

}  // namespace tedit::cad
