// SPDX-License-Identifier: AGPL-3.0-or-later
// Shells of parts.
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffset_MakeOffset.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include "cad/editor/ways.hpp"

namespace tedit::cad {

namespace {

constexpr double offset_tolerance = 1e-6;

/// What the walls enclose, each moved into the part by the thickness. Inner edges become round:
/// each point of the void is as far from the nearest one.
std::vector<TopoDS_Shape> inside_of(const TopoDS_Shape& solid, double thickness) {
  BRepOffset_MakeOffset offset;
  offset.Initialize(solid, -thickness, offset_tolerance, BRepOffset_Skin, Standard_False,
                    Standard_False, GeomAbs_Arc);
  offset.MakeOffsetShape();
  if (!offset.IsDone())
    return {};
  std::vector<TopoDS_Shape> insides;
  for (TopExp_Explorer shells(offset.Shape(), TopAbs_SHELL); shells.More(); shells.Next()) {
    auto inside = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current())).Solid();
    BRepLib::OrientClosedSolid(inside);
    insides.push_back(inside);
  }
  return insides;
}

TopoDS_Shape closed_shell(const part_model& part, const cad_step& step) {
  std::vector<TopoDS_Shape> tools;
  for (const auto& solid : solids_of(part.shape)) {
    const auto insides = inside_of(solid, step.distance_mm);
    if (insides.empty())
      return {};
    tools.insert(tools.end(), insides.begin(), insides.end());
  }
  for (const auto& drain : step.more)
    for (const auto& solid : solids_of_tool(drain))
      tools.push_back(solid);
  return combined(part, tools, body_operation::cut);
}

TopoDS_Shape open_shell(const part_model& part, const cad_step& step) {
  const auto walls = part.faces_of(step.surfaces);
  std::vector<TopoDS_Shape> shells;
  for (const auto& solid : solids_of(part.shape)) {
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(solid, TopAbs_FACE, own);
    TopTools_ListOfShape open;
    for (const auto& wall : walls)
      if (own.Contains(wall))
        open.Append(wall);
    BRepOffsetAPI_MakeThickSolid shell;
    shell.MakeThickSolidByJoin(solid, open, -step.distance_mm, offset_tolerance, BRepOffset_Skin,
                               Standard_False, Standard_False, GeomAbs_Arc);
    if (!shell.IsDone())
      return {};
    for (const auto& piece : solids_of(shell.Shape()))
      shells.push_back(piece);
  }
  return compound_of(shells);
}

}  // namespace

std::vector<way> ways_to_hollow(const part_model& part, const cad_step& step) {
  if (part.faces_of(step.surfaces).empty())
    return {{"walls moved inward", [&part, &step] { return closed_shell(part, step); }}};
  return {{"walls moved inward", [&part, &step] { return open_shell(part, step); }}};
}

}  // namespace tedit::cad
