// SPDX-License-Identifier: AGPL-3.0-or-later
// Solids of flat triangles.
#include <map>
#include <numeric>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Pln.hxx>

#include "cad/editor/ways.hpp"

namespace tedit::cad {

namespace {

/// Faces that share the edges and corners that their triangles do: nothing has to be sewn.
class facet_builder {
public:
  explicit facet_builder(const exact_tool& tool) : tool_(tool) {
    for (const auto& p : tool.points) {
      points_.emplace_back(p[0], p[1], p[2]);
      vertices_.push_back(BRepBuilderAPI_MakeVertex(points_.back()).Vertex());
    }
  }

  [[nodiscard]] TopoDS_Face face(const std::array<int, 3>& t) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t k = 0; k < 3; ++k)
      wire.Add(edge(t[k], t[(k + 1) % 3]));
    const auto& a = points_[static_cast<std::size_t>(t[0])];
    const gp_Vec normal = gp_Vec(a, points_[static_cast<std::size_t>(t[1])])
                            .Crossed(gp_Vec(a, points_[static_cast<std::size_t>(t[2])]));
    return BRepBuilderAPI_MakeFace(gp_Pln(a, gp_Dir(normal)), wire.Wire()).Face();
  }

private:
  TopoDS_Edge edge(int from, int to) {
    auto& known = edges_[std::minmax(from, to)];
    if (known.IsNull())
      known = BRepBuilderAPI_MakeEdge(vertices_[static_cast<std::size_t>(std::min(from, to))],
                                      vertices_[static_cast<std::size_t>(std::max(from, to))])
                .Edge();
    return TopoDS::Edge(from < to ? known : known.Reversed());
  }

  const exact_tool& tool_;
  std::vector<gp_Pnt> points_;
  std::vector<TopoDS_Vertex> vertices_;
  std::map<std::pair<int, int>, TopoDS_Edge> edges_;
};

/// Triangles that hang together over corners.
std::map<int, std::vector<std::array<int, 3>>> pieces_of(const exact_tool& tool) {
  std::vector<int> root(tool.points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto at = [&](int v) -> int& { return root[static_cast<std::size_t>(v)]; };
  const auto find = [&](int v) {
    while (at(v) != v)
      v = at(v) = at(at(v));
    return v;
  };
  for (const auto& t : tool.triangles)
    for (std::size_t k = 1; k < 3; ++k)
      at(find(t[k])) = find(t[0]);
  std::map<int, std::vector<std::array<int, 3>>> pieces;
  for (const auto& t : tool.triangles)
    pieces[find(t[0])].push_back(t);
  return pieces;
}

TopoDS_Shape merged(const TopoDS_Shape& solid) {
  try {
    ShapeUpgrade_UnifySameDomain unify(solid, Standard_True, Standard_True, Standard_False);
    unify.Build();
    return unify.Shape().IsNull() ? solid : unify.Shape();
  } catch (const Standard_Failure&) {
    return solid;  // A face for each triangle is the same shape.
  }
}

}  // namespace

std::vector<TopoDS_Shape> faceted(const exact_tool& tool) {
  facet_builder facets(tool);
  std::vector<TopoDS_Shape> solids;
  for (const auto& [root, triangles] : pieces_of(tool)) {
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    double volume = 0;
    for (const auto& t : triangles) {
      const auto face = facets.face(t);
      builder.Add(shell, face);
      volume += volume_below(face);
    }
    if (volume <= 0)
      return {};  // A void in another piece.
    shell.Closed(Standard_True);
    solids.push_back(merged(BRepBuilderAPI_MakeSolid(shell).Solid()));
  }
  return solids;
}

}  // namespace tedit::cad
