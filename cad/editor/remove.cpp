// SPDX-License-Identifier: AGPL-3.0-or-later
// Holes that are closed, bosses that are taken off.
#include <memory>

#include <BRepAlgoAPI_Defeaturing.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_FreeBounds.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_HSequenceOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include "cad/editor/feature.hpp"

namespace tedit::cad {

feature feature_of(const part_model& part, const std::vector<int>& surfaces) {
  feature result;
  result.faces = part.faces_of(surfaces);
  for (const auto& face : result.faces)
    result.gone.Add(face);
  const auto at = faces_at_edges(part.shape);
  for (Standard_Integer i = 1; i <= at.Extent(); ++i) {
    bool goes = false;
    TopoDS_Shape stays;
    for (const auto& face : at(i)) {
      goes = goes || result.gone.Contains(face);
      if (!result.gone.Contains(face))
        stays = face;
    }
    if (!goes || stays.IsNull())
      continue;
    result.rim.Add(at.FindKey(i));
    result.neighbours.Bind(at.FindKey(i), stays);
  }
  return result;
}

namespace {

bool touches(const TopoDS_Shape& shape, const TopTools_MapOfShape& edges) {
  for (TopExp_Explorer all(shape, TopAbs_EDGE); all.More(); all.Next())
    if (edges.Contains(all.Current()))
      return true;
  return false;
}

/// The face without its inner outlines on the rim; null where its outer one is.
TopoDS_Shape without_rim(const TopoDS_Face& face, const feature& what) {
  const auto forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const auto outer = BRepTools::OuterWire(forward);
  if (outer.IsNull() || touches(outer, what.rim))
    return {};
  auto copy = forward.EmptyCopied();
  BRep_Builder builder;
  for (TopExp_Explorer wires(forward, TopAbs_WIRE); wires.More(); wires.Next())
    if (!touches(wires.Current(), what.rim))
      builder.Add(copy, wires.Current());
  return copy.Oriented(face.Orientation());
}

/// A wall around a hole is the same surface without the hole: nothing is computed.
TopoDS_Shape drop_outlines(const part_model& part, const feature& what) {
  TopTools_DataMapOfShapeShape images;
  BRep_Builder builder;
  std::vector<TopoDS_Shape> solids;
  for (const auto& solid : solids_of(part.shape)) {
    auto copy = solid.EmptyCopied();
    for (TopExp_Explorer shells(solid.Oriented(TopAbs_FORWARD), TopAbs_SHELL); shells.More();
         shells.Next()) {
      auto shell = shells.Current().Oriented(TopAbs_FORWARD).EmptyCopied();
      std::size_t count = 0;
      for (TopExp_Explorer faces(shells.Current().Oriented(TopAbs_FORWARD), TopAbs_FACE);
           faces.More(); faces.Next()) {
        const auto& face = faces.Current();
        if (what.gone.Contains(face))
          continue;
        ++count;
        if (!touches(face, what.rim)) {
          builder.Add(shell, face);
          continue;
        }
        if (!images.IsBound(face)) {
          const auto image = without_rim(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), what);
          if (image.IsNull())
            return {};
          images.Bind(face, image);
        }
        builder.Add(shell, images.Find(face).Oriented(face.Orientation()));
      }
      if (count > 0)
        builder.Add(copy, shell.Oriented(shells.Current().Orientation()));
    }
    solids.push_back(copy);
  }
  return compound_of(solids);
}

/// What closes one loop of the rim: a plane where it lies in one, as mouths of holes do, else the
/// surface that is all around it.
TopoDS_Face cap_of(const TopoDS_Wire& loop, const feature& what) {
  if (BRepBuilderAPI_MakeFace flat(loop, Standard_True); flat.IsDone())
    return flat.Face();
  TopoDS_Shape around;
  for (TopExp_Explorer edges(loop, TopAbs_EDGE); edges.More(); edges.Next()) {
    const auto* next = what.neighbours.Seek(edges.Current());
    if (!next || !(around.IsNull() || around.IsSame(*next)))
      return {};
    around = *next;
  }
  if (around.IsNull())
    return {};
  BRepBuilderAPI_MakeFace on(BRep_Tool::Surface(TopoDS::Face(around)), loop);
  return on.IsDone() ? on.Face() : TopoDS_Face();
}

}  // namespace

plug plug_of(const feature& what) {
  plug result;
  Handle(TopTools_HSequenceOfShape) edges = new TopTools_HSequenceOfShape;
  for (TopTools_MapOfShape::Iterator edge(what.rim); edge.More(); edge.Next())
    edges->Append(edge.Value());
  Handle(TopTools_HSequenceOfShape) loops = new TopTools_HSequenceOfShape;
  constexpr double gap_mm = 1e-5;
  ShapeAnalysis_FreeBounds::ConnectEdgesToWires(edges, gap_mm, Standard_True, loops);
  BRepBuilderAPI_Sewing sewing(gap_mm);
  for (const auto& face : what.faces)
    sewing.Add(face);
  for (const auto& loop : *loops) {
    const auto cap = cap_of(TopoDS::Wire(loop), what);
    if (cap.IsNull())
      return {};
    result.caps.push_back(cap);
    sewing.Add(cap);
  }
  sewing.Perform();
  std::vector<TopoDS_Shape> solids;
  for (TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL); shells.More(); shells.Next()) {
    if (!BRep_Tool::IsClosed(shells.Current()))
      return {};
    auto solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current())).Solid();
    BRepLib::OrientClosedSolid(solid);
    solids.push_back(solid);
  }
  if (!solids.empty())
    result.solids = solids.size() == 1 ? solids.front() : compound_of(solids);
  return result;
}

namespace {

bool owns_some(const TopoDS_Shape& solid, const feature& what) {
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
    if (what.gone.Contains(faces.Current()))
      return true;
  return false;
}

TopoDS_Shape defeatured(const part_model& part, const feature& what) {
  BRepAlgoAPI_Defeaturing algorithm;
  algorithm.SetShape(part.shape);
  for (const auto& face : what.faces)
    algorithm.AddFaceToRemove(face);
  algorithm.SetRunParallel(Standard_False);
  algorithm.Build();
  return algorithm.IsDone() && !algorithm.HasErrors() ? algorithm.Shape() : TopoDS_Shape();
}

}  // namespace

std::vector<way> ways_to_remove(const part_model& part, const std::vector<int>& surfaces,
                                body_operation operation) {
  const auto what = std::make_shared<feature>(feature_of(part, surfaces));
  if (what->faces.empty())
    return {};
  return {{"outlines dropped", [&part, what] { return drop_outlines(part, *what); }},
          {"plug",
           [&part, what, operation] {
             const auto plug = plug_of(*what).solids;
             if (plug.IsNull())
               return TopoDS_Shape();
             return combined(part, {plug}, operation,
                             [&](const TopoDS_Shape& solid) { return owns_some(solid, *what); });
           }},
          {"neighbours extended", [&part, what] { return defeatured(part, *what); }}};
}

}  // namespace tedit::cad
