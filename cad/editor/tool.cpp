// SPDX-License-Identifier: AGPL-3.0-or-later
// Tools by their exact shape.
#include <cmath>
#include <memory>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gp_Pln.hxx>

#include "cad/editor/ways.hpp"

namespace tedit::cad {

namespace {

gp_XYZ xyz(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

gp_Pnt point_at(const exact_tool& tool, double x, double y, double z) {
  const auto& f = tool.frame;
  return gp_Pnt(xyz(f[0]) + x * xyz(f[1]) + y * xyz(f[2]) + z * xyz(f[3]));
}

/// The middle of an arc that turns by 4 atan(bulge): off its chord's middle by bulge half chords,
/// to the right of the way.
gp_Pnt middle_of_arc(const exact_tool& tool, const outline_corner& a, const outline_corner& b) {
  const double x = (a.x + b.x) / 2 + a.bulge * (b.y - a.y) / 2;
  const double y = (a.y + b.y) / 2 - a.bulge * (b.x - a.x) / 2;
  return point_at(tool, x, y, tool.from);
}

TopoDS_Wire wire_of(const exact_tool& tool, const std::vector<outline_corner>& outline) {
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    const auto from = point_at(tool, a.x, a.y, tool.from);
    const auto to = point_at(tool, b.x, b.y, tool.from);
    if (a.bulge == 0)
      wire.Add(BRepBuilderAPI_MakeEdge(from, to));
    else
      wire.Add(
        BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, middle_of_arc(tool, a, b), to).Value()));
  }
  return wire.Wire();
}

/// @pre outlines do not lie in each other.
std::vector<TopoDS_Shape> extruded(const exact_tool& tool) {
  const gp_Dir z(xyz(tool.frame[3]));
  const gp_Pln plane(point_at(tool, 0, 0, tool.from), z);
  std::vector<TopoDS_Shape> solids;
  for (const auto& outline : tool.outlines) {
    const BRepBuilderAPI_MakeFace face(plane, wire_of(tool, outline));
    solids.push_back(BRepPrimAPI_MakePrism(face, gp_Vec(z) * (tool.to - tool.from)).Shape());
  }
  return solids;
}

std::vector<TopoDS_Shape> turned(const exact_tool& tool) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const auto& p : tool.section)
    polygon.Add(point_at(tool, p[0], 0, p[1]));
  polygon.Close();
  const BRepBuilderAPI_MakeFace face(polygon.Wire(), Standard_True);
  const gp_Ax1 axis(point_at(tool, 0, 0, 0), gp_Dir(xyz(tool.frame[3])));
  return {BRepPrimAPI_MakeRevol(face, axis).Shape()};
}

}  // namespace

std::vector<way> ways_with_tool(const part_model& part, const cad_step& step) {
  const auto operation = step.kind == step_kind::cut   ? body_operation::cut
                         : step.kind == step_kind::add ? body_operation::add
                                                       : body_operation::keep;
  return {{"tool", [&part, &step, operation] {
             return combined(part,
                             step.tool.section.empty() ? extruded(step.tool) : turned(step.tool),
                             operation);
           }}};
}

}  // namespace tedit::cad
