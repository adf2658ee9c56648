// SPDX-License-Identifier: AGPL-3.0-or-later
// Tools by their exact shape.
#include <algorithm>
#include <cmath>
#include <map>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp.hxx>
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

double signed_area(const std::vector<outline_corner>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return 0.5 * twice;
}

bool is_inside(const outline_corner& p, const std::vector<outline_corner>& outline) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const auto& a = outline[i];
    const auto& b = outline[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
      inside = !inside;
  }
  return inside;
}

/// Outlines that do not cross, even-odd filled: one in an odd number of others is a hole of the
/// innermost of these.
class nesting {
public:
  explicit nesting(const std::vector<std::vector<outline_corner>>& outlines) : outlines_(outlines) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
      for (std::size_t k = 0; k < outlines.size(); ++k)
        depth_[i] += k != i && is_inside(outlines[i].front(), outlines[k]);
  }

  [[nodiscard]] bool is_hole(std::size_t i) const { return depth_.at(i) % 2 == 1; }

  [[nodiscard]] std::vector<std::size_t> holes_of(std::size_t outer) const {
    std::vector<std::size_t> holes;
    for (std::size_t i = 0; i < outlines_.size(); ++i)
      if (depth_.at(i) == depth_.at(outer) + 1 && is_inside(outlines_[i].front(), outlines_[outer]))
        holes.push_back(i);
    return holes;
  }

private:
  const std::vector<std::vector<outline_corner>>& outlines_;
  std::map<std::size_t, int> depth_;
};

/// Counterclockwise as seen against z, a hole the other way round. @pre more than one outline: no
/// arcs, whose area is not looked at.
TopoDS_Wire turned_wire(const exact_tool& tool, std::vector<outline_corner> outline, bool is_hole) {
  if (tool.outlines.size() > 1 && (signed_area(outline) < 0) != is_hole)
    std::ranges::reverse(outline);
  return wire_of(tool, outline);
}

std::vector<TopoDS_Shape> extruded(const exact_tool& tool) {
  const gp_Dir z(xyz(tool.frame[3]));
  const gp_Pln plane(point_at(tool, 0, 0, tool.from), z);
  const nesting nested(tool.outlines);
  std::vector<TopoDS_Shape> solids;
  for (std::size_t i = 0; i < tool.outlines.size(); ++i) {
    if (nested.is_hole(i))
      continue;
    BRepBuilderAPI_MakeFace face(plane, turned_wire(tool, tool.outlines[i], false));
    for (const auto hole : nested.holes_of(i))
      face.Add(turned_wire(tool, tool.outlines[hole], true));
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

/// What is left of each solid on either side of a half-space: pieces of one after the other.
TopoDS_Shape split(const part_model& part, const exact_tool& above) {
  auto below = above;
  below.to = -above.to;
  std::vector<TopoDS_Shape> pieces;
  for (const auto& solid : solids_of(part.shape)) {
    part_model one;
    one.shape = solid;
    TopExp::MapShapes(solid, TopAbs_FACE, one.faces);
    for (const auto& side : {above, below}) {
      const auto rest = combined(one, solids_of_tool(side), body_operation::cut);
      if (rest.IsNull())
        return {};
      for (const auto& piece : solids_of(rest))
        pieces.push_back(piece);
    }
  }
  return compound_of(pieces);
}

}  // namespace

std::vector<TopoDS_Shape> solids_of_tool(const exact_tool& tool) {
  return !tool.triangles.empty() ? faceted(tool)
         : tool.section.empty()  ? extruded(tool)
                                 : turned(tool);
}

std::vector<way> ways_with_tool(const part_model& part, const cad_step& step) {
  if (step.kind == step_kind::split)
    return {{"both sides", [&part, &step] { return split(part, step.tool); }}};
  const auto operation = step.kind == step_kind::cut   ? body_operation::cut
                         : step.kind == step_kind::add ? body_operation::add
                                                       : body_operation::keep;
  return {{"tool", [&part, &step, operation] {
             auto tools = solids_of_tool(step.tool);
             for (const auto& one : step.more)
               for (const auto& solid : solids_of_tool(one))
                 tools.push_back(solid);
             return tools.empty() ? TopoDS_Shape() : combined(part, tools, operation);
           }}};
}

}  // namespace tedit::cad
