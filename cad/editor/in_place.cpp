// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/in_place.hpp"

#include <array>
#include <cmath>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Vec2d.hxx>

#include "cad/editor/moved_surfaces.hpp"

namespace tedit::cad {

namespace {

class in_place_mover {
public:
  in_place_mover(const part_model& part, const cad_step& step)
      : part_(part), surfaces_(part, step) {
    TopExp::MapShapesAndAncestors(part.shape, TopAbs_VERTEX, TopAbs_FACE, faces_at_vertex_);
    TopExp::MapShapesAndAncestors(part.shape, TopAbs_VERTEX, TopAbs_EDGE, edges_at_vertex_);
    TopExp::MapShapesAndAncestors(part.shape, TopAbs_EDGE, TopAbs_FACE, faces_at_edge_);
  }

  TopoDS_Shape made() {
    if (surfaces_.empty())
      return {};
    try {
      return rebuilt(part_.shape);
    } catch (const nowhere&) {
      return {};
    }
  }

private:
  TopoDS_Vertex new_vertex(const TopoDS_Vertex& old) {
    if (!vertices_.IsBound(old)) {
      const auto start = BRep_Tool::Pnt(old);
      const auto faces = surfaces_.faces_around(faces_at_vertex_.FindFromKey(old));
      const auto at =
        surfaces_.moves(faces.front()) ? surfaces_.place_of(start, faces, aside_at(old)) : start;
      TopoDS_Vertex made = old;
      if (!surfaces_.is_same(at, start))
        BRep_Builder().MakeVertex(made, at, BRep_Tool::Tolerance(old));
      vertices_.Bind(old, made);
    }
    return TopoDS::Vertex(vertices_.Find(old));
  }

  /// Where it does not go: across smooth edges that end there.
  [[nodiscard]] std::vector<gp_Vec> aside_at(const TopoDS_Vertex& vertex) const {
    std::vector<gp_Vec> aside;
    for (const auto& edge : edges_at_vertex_.FindFromKey(vertex)) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(edge)))
        continue;
      const BRepAdaptor_Curve curve(TopoDS::Edge(edge));
      gp_Pnt at;
      gp_Vec along;
      curve.D1(BRep_Tool::Parameter(vertex, TopoDS::Edge(edge)), at, along);
      if (const auto way =
            surfaces_.aside_of(at, along, surfaces_.faces_around(faces_at_edge_.FindFromKey(edge))))
        aside.push_back(*way);
    }
    return aside;
  }

  /// Forward, as the old one runs.
  TopoDS_Edge new_edge(const TopoDS_Edge& any) {
    const auto old = TopoDS::Edge(any.Oriented(TopAbs_FORWARD));
    if (!edges_.IsBound(old))
      edges_.Bind(old, make_edge(old));
    return TopoDS::Edge(edges_.Find(old));
  }

  TopoDS_Edge make_edge(const TopoDS_Edge& old) {
    const auto faces = surfaces_.faces_around(faces_at_edge_.FindFromKey(old));
    TopoDS_Vertex first;
    TopoDS_Vertex last;
    TopExp::Vertices(old, first, last);
    const std::array ends{new_vertex(first), new_vertex(last)};
    if (!surfaces_.moves(faces.front()) && ends[0].IsSame(first) && ends[1].IsSame(last))
      return old;
    if (BRep_Tool::Degenerated(old))
      throw nowhere();
    Standard_Real from = 0;
    Standard_Real to = 0;
    const auto before = BRep_Tool::Curve(old, from, to);
    const std::array places{BRep_Tool::Pnt(ends[0]), BRep_Tool::Pnt(ends[1])};
    if (before.IsNull())
      throw nowhere();
    auto curve = surfaces_.curve_of(before, from, to, faces, places);
    gp_Pnt at;
    gp_Vec then;
    gp_Vec now;
    before->D1(from, at, then);
    curve->D1(surfaces_.parameter_of(curve, places[0]), at, now);
    if (then.Dot(now) < 0)
      curve = curve->Reversed();
    return edge_on(curve, ends, places, BRep_Tool::Tolerance(old));
  }

  TopoDS_Edge edge_on(const Handle(Geom_Curve) & curve, const std::array<TopoDS_Vertex, 2>& ends,
                      const std::array<gp_Pnt, 2>& places, double tolerance) const {
    const double from = surfaces_.parameter_of(curve, places[0]);
    double to = ends[0].IsSame(ends[1]) ? from : surfaces_.parameter_of(curve, places[1]);
    if (to <= from + 1e-12 && curve->IsPeriodic())
      to += curve->Period();
    else if (to <= from && curve->IsClosed())
      to += curve->LastParameter() - curve->FirstParameter();
    if (to <= from)
      throw nowhere();
    TopoDS_Edge edge;
    BRep_Builder builder;
    builder.MakeEdge(edge, curve, tolerance);
    builder.Add(edge, ends[0].Oriented(TopAbs_FORWARD));
    builder.Add(edge, ends[1].Oriented(TopAbs_REVERSED));
    builder.Range(edge, from, to);
    return edge;
  }

  /// One for all solids that share it.
  TopoDS_Shape new_face(const TopoDS_Face& old) {
    if (!faces_.IsBound(old))
      faces_.Bind(old, make_face(TopoDS::Face(old.Oriented(TopAbs_FORWARD))));
    return faces_.Find(old).Oriented(old.Orientation());
  }

  /// With its edges where they are now; the same face where none of them moved. Forward: which of a
  /// seam's two curves belongs to which side depends on that.
  TopoDS_Face make_face(const TopoDS_Face& old) {
    bool is_same = !surfaces_.moves(old);
    for (TopExp_Explorer edges(old, TopAbs_EDGE); edges.More(); edges.Next())
      is_same = is_same && new_edge(TopoDS::Edge(edges.Current())).IsSame(edges.Current());
    if (is_same)
      return old;
    TopoDS_Face made;
    BRep_Builder builder;
    TopLoc_Location place;
    auto surface = BRep_Tool::Surface(old, place);
    if (surfaces_.moves(old)) {
      surface = surfaces_.after(old);
      place = {};
    }
    builder.MakeFace(made, surface, place, BRep_Tool::Tolerance(old));
    for (TopoDS_Iterator wires(old); wires.More(); wires.Next())
      builder.Add(made, new_wire(wires.Value(), old, made));
    return made;
  }

  TopoDS_Shape new_wire(const TopoDS_Shape& old, const TopoDS_Face& of, const TopoDS_Face& made) {
    TopoDS_Wire wire;
    BRep_Builder builder;
    builder.MakeWire(wire);
    for (TopoDS_Iterator edges(old.Oriented(TopAbs_FORWARD)); edges.More(); edges.Next()) {
      const auto before = TopoDS::Edge(edges.Value());
      const auto edge = new_edge(before);
      if (!edge.IsSame(before))
        add_parameter_curve(edge, made, before, of);
      builder.Add(wire, edge.Oriented(before.Orientation()));
    }
    wire.Closed(true);
    return wire.Oriented(old.Orientation());
  }

  /// In the same turn of a round surface as before.
  static void add_parameter_curve(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                  const TopoDS_Edge& old_edge, const TopoDS_Face& old_face) {
    ShapeFix_Edge fix;
    const bool is_seam = BRep_Tool::IsClosed(old_edge, old_face);
    fix.FixAddPCurve(edge, face, is_seam, 1e-7);
    const auto forward = TopoDS::Edge(old_edge.Oriented(TopAbs_FORWARD));
    const auto curve = in_turn_of(forward, old_face, edge, face);
    if (!curve.IsNull()) {
      BRep_Builder builder;
      const double tolerance = BRep_Tool::Tolerance(edge);
      if (is_seam)
        builder.UpdateEdge(edge, curve,
                           in_turn_of(TopoDS::Edge(forward.Reversed()), old_face, edge, face), face,
                           tolerance);
      else
        builder.UpdateEdge(edge, curve, face, tolerance);
    }
    fix.FixSameParameter(edge);
    fix.FixVertexTolerance(edge);
  }

  /// Null on a plane.
  static Handle(Geom2d_Curve) in_turn_of(const TopoDS_Edge& old_edge, const TopoDS_Face& old_face,
                                         const TopoDS_Edge& edge, const TopoDS_Face& face) {
    const auto surface = BRep_Tool::Surface(face);
    if (!surface->IsUPeriodic() && !surface->IsVPeriodic())
      return {};
    Standard_Real from = 0;
    Standard_Real to = 0;
    const auto before = BRep_Tool::CurveOnSurface(old_edge, old_face, from, to);
    if (before.IsNull())
      return {};
    const auto wanted = before->Value((from + to) / 2);
    const auto now = BRep_Tool::CurveOnSurface(edge, face, from, to);
    if (now.IsNull())
      throw nowhere();
    const auto found = now->Value((from + to) / 2);
    const auto turns = [](double apart, bool is_periodic, double period) {
      return is_periodic ? period * std::round(apart / period) : 0;
    };
    return Handle(Geom2d_Curve)::DownCast(
      now->Translated({turns(wanted.X() - found.X(), surface->IsUPeriodic(),
                             surface->IsUPeriodic() ? surface->UPeriod() : 1),
                       turns(wanted.Y() - found.Y(), surface->IsVPeriodic(),
                             surface->IsVPeriodic() ? surface->VPeriod() : 1)}));
  }

  /// Shells, solids and compounds with the new faces.
  TopoDS_Shape rebuilt(const TopoDS_Shape& old) {
    if (old.ShapeType() == TopAbs_FACE)
      return new_face(TopoDS::Face(old));
    auto made = old.EmptyCopied();
    made.Location(TopLoc_Location());
    made.Orientation(TopAbs_FORWARD);
    BRep_Builder builder;
    bool is_same = true;
    for (TopoDS_Iterator parts(old.Oriented(TopAbs_FORWARD)); parts.More(); parts.Next()) {
      const auto part = rebuilt(parts.Value());
      is_same = is_same && part.IsSame(parts.Value());
      builder.Add(made, part);
    }
    made.Closed(old.Closed());
    return is_same ? old : made.Oriented(old.Orientation());
  }

  const part_model& part_;
  const moved_surfaces surfaces_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_at_vertex_;
  TopTools_IndexedDataMapOfShapeListOfShape edges_at_vertex_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_at_edge_;
  TopTools_DataMapOfShapeShape vertices_;
  TopTools_DataMapOfShapeShape edges_;
  TopTools_DataMapOfShapeShape faces_;
};

}  // namespace

TopoDS_Shape moved_in_place(const part_model& part, const cad_step& step) {
  return in_place_mover(part, step).made();
}

}  // namespace tedit::cad
