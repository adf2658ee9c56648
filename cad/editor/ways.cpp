// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/ways.hpp"

#include <cmath>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax3.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

namespace tedit::cad {

namespace {

template <class Operation>
TopoDS_Shape run(const TopoDS_Shape& solid, const std::vector<TopoDS_Shape>& tools) {
  TopTools_ListOfShape arguments;
  TopTools_ListOfShape others;
  arguments.Append(solid);
  for (const auto& tool : tools)
    others.Append(tool);
  Operation operation;
  operation.SetArguments(arguments);
  operation.SetTools(others);
  operation.SetNonDestructive(true);
  operation.Build();
  return operation.HasErrors() ? TopoDS_Shape() : operation.Shape();
}

TopoDS_Shape run(body_operation operation, const TopoDS_Shape& solid,
                 const std::vector<TopoDS_Shape>& tools) {
  switch (operation) {
    case body_operation::cut:
      return run<BRepAlgoAPI_Cut>(solid, tools);
    case body_operation::add:
      return run<BRepAlgoAPI_Fuse>(solid, tools);
    case body_operation::keep:
      return run<BRepAlgoAPI_Common>(solid, tools);
  }
  return {};
}

/// Are both pieces of one plane or cylinder, or of what is one surface in the model?
bool are_of_one_surface(const TopoDS_Face& a, const TopoDS_Face& b) {
  const BRepAdaptor_Surface one(a);
  const BRepAdaptor_Surface other(b);
  if (BRep_Tool::Surface(a) == BRep_Tool::Surface(b))
    return true;
  if (one.GetType() != other.GetType())
    return false;
  if (one.GetType() == GeomAbs_Plane)
    return one.Plane().Position().IsCoplanar(other.Plane().Position(), Precision::Confusion(),
                                             Precision::Angular());
  return one.GetType() == GeomAbs_Cylinder &&
         one.Cylinder().Axis().IsCoaxial(other.Cylinder().Axis(), Precision::Angular(),
                                         Precision::Confusion()) &&
         std::abs(one.Cylinder().Radius() - other.Cylinder().Radius()) < Precision::Confusion();
}

/// Edges between faces that are as they were stay: they part surfaces that have ids of their own.
bool may_go(const TopTools_ListOfShape& faces, const TopTools_IndexedMapOfShape& old,
            new_edges edges) {
  bool is_old = true;
  for (const auto& face : faces)
    is_old = is_old && old.Contains(face);
  return !is_old && (edges == new_edges::go ||
                     (faces.Extent() == 2 &&
                      are_of_one_surface(TopoDS::Face(faces.First()), TopoDS::Face(faces.Last()))));
}

TopoDS_Shape without_new_edges(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& old,
                               new_edges edges) {
  try {
    ShapeUpgrade_UnifySameDomain unify(shape, Standard_True, Standard_True, Standard_False);
    const auto at = faces_at_edges(shape);
    for (Standard_Integer i = 1; i <= at.Extent(); ++i)
      if (!may_go(at(i), old, edges))
        unify.KeepShape(at.FindKey(i));
    unify.Build();
    return unify.Shape().IsNull() ? shape : unify.Shape();
  } catch (const Standard_Failure&) {
    return shape;  // 7.6.3 throws on some parts; edges across a face are no fault of the shape.
  }
}

}  // namespace

std::vector<TopoDS_Shape> solids_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_SOLID, map);
  std::vector<TopoDS_Shape> solids;
  for (Standard_Integer i = 1; i <= map.Extent(); ++i)
    solids.push_back(map(i));
  return solids;
}

TopoDS_Shape compound_of(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const auto& shape : shapes)
    builder.Add(all, shape);
  return all;
}

TopoDS_Shape combined(const part_model& part, const std::vector<TopoDS_Shape>& tools,
                      body_operation operation,
                      const std::function<bool(const TopoDS_Shape& solid)>& concerns,
                      new_edges edges) {
  std::vector<TopoDS_Shape> result;
  for (const auto& solid : solids_of(part.shape)) {
    if (concerns && !concerns(solid)) {
      result.push_back(solid);
      continue;
    }
    const auto made = run(operation, solid, tools);
    if (made.IsNull())
      return {};
    for (const auto& piece :
         solids_of(edges == new_edges::stay ? made : without_new_edges(made, part.faces, edges)))
      result.push_back(piece);
  }
  return compound_of(result);
}

std::vector<way> ways_of(const part_model& part, const cad_step& step, const edited_surface& mesh) {
  switch (step.kind) {
    case step_kind::none:
      return {{"as it was", [&part] { return part.shape; }}};
    case step_kind::remove:
      return ways_to_remove(part, step.surfaces,
                            step.volume_change_mm3 > 0 ? body_operation::add : body_operation::cut);
    case step_kind::shift:
      return ways_to_shift(part, step, mesh);
    case step_kind::round:
      return ways_to_round(part, step);
    case step_kind::cut:
    case step_kind::add:
    case step_kind::keep:
    case step_kind::split:
      return ways_with_tool(part, step);
    case step_kind::copy:
      return ways_to_copy(part, step);
    case step_kind::hollow:
      return ways_to_hollow(part, step);
  }
  return {};
}

}  // namespace tedit::cad
