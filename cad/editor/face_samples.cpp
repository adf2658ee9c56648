// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/face_samples.hpp"

#include <algorithm>
#include <cmath>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_CLProps.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "cad/editor/face_probe.hpp"

namespace tedit::cad {

namespace {

constexpr int most_a_side = 40;

struct edge_sample {
  gp_Pnt at;
  double curvature = 0;
};

std::vector<edge_sample> samples_of_rim(const TopoDS_Face& face) {
  constexpr int count = 12;
  std::vector<edge_sample> result;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const auto edge = TopoDS::Edge(edges.Current());
    if (BRep_Tool::Degenerated(edge))
      continue;
    const BRepAdaptor_Curve curve(edge);
    const double from = curve.FirstParameter();
    const double to = curve.LastParameter();
    for (int i = 0; i < count; ++i) {
      BRepLProp_CLProps properties(curve, from + (to - from) * (i + 0.5) / count, 2, 1e-9);
      result.push_back(
        {properties.Value(), properties.IsTangentDefined() ? properties.Curvature() : 0});
    }
  }
  return result;
}

}  // namespace

std::vector<face_sample> samples_of(const TopoDS_Face& face, double spacing) {
  const BRepAdaptor_Surface surface(face);
  BRepTopAdaptor_FClass2d inside(face, 1e-7);
  const auto rim = samples_of_rim(face);
  Standard_Real u1 = 0;
  Standard_Real u2 = 0;
  Standard_Real v1 = 0;
  Standard_Real v2 = 0;
  BRepTools::UVBounds(face, u1, u2, v1, v2);
  const auto steps = [&](const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c) {
    const double length = a.Distance(b) + b.Distance(c);
    return std::clamp(static_cast<int>(2 * length / spacing), 6, most_a_side);
  };
  const double um = (u1 + u2) / 2;
  const double vm = (v1 + v2) / 2;
  const int nu = steps(surface.Value(u1, vm), surface.Value(um, vm), surface.Value(u2, vm));
  const int nv = steps(surface.Value(um, v1), surface.Value(um, vm), surface.Value(um, v2));
  std::vector<face_sample> result;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const double u = u1 + (u2 - u1) * (i + 0.5) / nu;
      const double v = v1 + (v2 - v1) * (j + 0.5) / nv;
      if (inside.Perform(gp_Pnt2d(u, v), Standard_False) != TopAbs_IN)
        continue;
      face_sample sample{surface.Value(u, v), curvature_of(surface, u, v)};
      for (const auto& e : rim)
        if (e.at.Distance(sample.at) < spacing)
          sample.curvature = std::max(sample.curvature, e.curvature);
      result.push_back(sample);
    }
  return result;
}

}  // namespace tedit::cad
