// SPDX-License-Identifier: AGPL-3.0-or-later
// Edges that are no longer than rounding: where one of them ends a seam, Gmsh cannot mesh the face.
#include <cmath>
#include <cstdio>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Wireframe.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "cad/reader/content.hpp"

namespace tedit::cad {

namespace {

/// Of the solid's size: an edge that is shorter says nothing.
constexpr double no_length = 1e-6;

/// Not one at a point of a surface, as the tip of a cone is.
bool is_shorter(const TopoDS_Edge& edge, double length) {
  TopoDS_Vertex first;
  TopoDS_Vertex last;
  TopExp::Vertices(edge, first, last);
  if (BRep_Tool::Degenerated(edge) || first.IsNull() || last.IsNull() ||
      BRep_Tool::Pnt(first).Distance(BRep_Tool::Pnt(last)) >= length)
    return false;
  try {
    const BRepAdaptor_Curve curve(edge);
    return GCPnts_AbscissaPoint::Length(curve) < length;
  } catch (const Standard_Failure&) {
    return false;  // It has no curve.
  }
}

std::vector<TopoDS_Edge> shorter_edges(const TopoDS_Shape& solid, double length) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(solid, TopAbs_EDGE, edges);
  std::vector<TopoDS_Edge> found;
  for (Standard_Integer i = 1; i <= edges.Extent(); ++i)
    if (const auto edge = TopoDS::Edge(edges(i)); is_shorter(edge, length))
      found.push_back(edge);
  return found;
}

Standard_Integer count_faces(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces.Extent();
}

std::string notice_of(const std::vector<TopoDS_Edge>& edges, double length) {
  const auto at = BRep_Tool::Pnt(TopExp::FirstVertex(edges.front()));
  char text[160];
  std::snprintf(text, sizeof(text),
                "edges shorter than %.2g mm were closed up, %zu in all, the first at %.4g, %.4g, "
                "%.4g mm",
                length, edges.size(), at.X(), at.Y(), at.Z());
  return text;
}

/// The solid without its shortest edges; null where that is another shape, or none.
TopoDS_Shape without_edges(const TopoDS_Shape& solid, double length, cad_content& content) {
  try {
    ShapeFix_Wireframe fix(solid);
    fix.SetPrecision(length);
    fix.SetMaxTolerance(length);
    fix.ModeDropSmallEdges() = Standard_True;
    if (!fix.FixSmallEdges())
      return {};
    const auto mended = fix.Shape();
    if (mended.IsNull() || mended.ShapeType() != TopAbs_SOLID ||
        count_faces(mended) != count_faces(solid) || !BRepCheck_Analyzer(mended).IsValid())
      return {};
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
      if (const auto image = fix.Context()->Apply(faces.Current()); !image.IsSame(faces.Current()))
        content.carry_over(faces.Current(), image);
    return mended;
  } catch (const Standard_Failure&) {
    return {};
  }
}

}  // namespace

void close_up_edges(cad_content& content, const teller& tells) {
  tells.stage(0.66, "looking for edges of no length");
  for (auto& one : content.solids) {
    Bnd_Box box;
    BRepBndLib::Add(one.shape, box);
    const double length = no_length * std::sqrt(box.SquareExtent());
    const auto edges = shorter_edges(one.shape, length);
    if (edges.empty())
      continue;
    if (const auto mended = without_edges(one.shape, length, content); !mended.IsNull()) {
      one.shape = mended;
      content.notices.push_back(notice_of(edges, length));
    }
  }
}

}  // namespace tedit::cad
