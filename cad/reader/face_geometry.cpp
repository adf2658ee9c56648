// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/reader/face_geometry.hpp"

#include <algorithm>
#include <cmath>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace tedit::cad {

namespace {

constexpr double millimetre = 1e-3;

vec3 metres(const gp_Pnt& p) {
  return millimetre * vec3{p.X(), p.Y(), p.Z()};
}

surface_geometry at(surface_geometry::kind type, const gp_Ax3& place) {
  surface_geometry result;
  const auto& axis = place.Direction();
  result.type = type;
  result.point = metres(place.Location());
  result.axis = {axis.X(), axis.Y(), axis.Z()};
  return result;
}

std::vector<double> knots_of(const TColStd_Array1OfReal& knots) {
  return {knots.begin(), knots.end()};
}

/// Null where there are more poles or a higher degree than `spline_surface` has.
std::shared_ptr<const spline_surface> spline_of(const Geom_BSplineSurface& from) {
  spline_surface to;
  to.degree = {static_cast<std::uint32_t>(from.UDegree()),
               static_cast<std::uint32_t>(from.VDegree())};
  to.knots = {knots_of(from.UKnotSequence()), knots_of(from.VKnotSequence())};
  const auto* weights = from.Weights();
  for (Standard_Integer i = 1; i <= from.NbUPoles(); ++i)
    for (Standard_Integer j = 1; j <= from.NbVPoles(); ++j) {
      to.poles.push_back(metres(from.Pole(i, j)));
      if (weights)
        to.weights.push_back(weights->Value(i, j));
    }
  return is_possible(to) ? std::make_shared<const spline_surface>(std::move(to)) : nullptr;
}

/// All that is asked for this is a spline exactly. As far as the face goes: what it is a piece of
/// may be endless, or closed.
surface_geometry free_form(const TopoDS_Face& face) {
  Standard_Real u1 = 0;
  Standard_Real u2 = 0;
  Standard_Real v1 = 0;
  Standard_Real v2 = 0;
  BRepTools::UVBounds(face, u1, u2, v1, v2);
  surface_geometry result;
  try {
    const Handle(Geom_Surface) whole = BRep_Tool::Surface(face);
    const Handle(Geom_Surface) piece = new Geom_RectangularTrimmedSurface(whole, u1, u2, v1, v2);
    const auto spline = GeomConvert::SurfaceToBSplineSurface(piece);
    spline->SetUNotPeriodic();
    spline->SetVNotPeriodic();
    result.spline = spline_of(*spline);
  } catch (const Standard_Failure&) {
    return {};
  }
  if (result.spline)
    result.type = surface_geometry::kind::spline;
  return result;
}

surface_geometry shape_of(const TopoDS_Face& face) {
  using kind = surface_geometry::kind;
  const BRepAdaptor_Surface surface(face, Standard_False);
  surface_geometry result;
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      return at(kind::plane, surface.Plane().Position());
    case GeomAbs_Cylinder:
      result = at(kind::cylinder, surface.Cylinder().Position());
      result.radius = millimetre * surface.Cylinder().Radius();
      return result;
    case GeomAbs_Cone:
      result = at(kind::cone, surface.Cone().Position());
      result.radius = millimetre * surface.Cone().RefRadius();
      result.slope = std::tan(surface.Cone().SemiAngle());
      return result;
    case GeomAbs_Sphere:
      result = at(kind::sphere, surface.Sphere().Position());
      result.axis = {};
      result.radius = millimetre * surface.Sphere().Radius();
      return result;
    case GeomAbs_Torus:
      result = at(kind::torus, surface.Torus().Position());
      result.radius = millimetre * surface.Torus().MajorRadius();
      result.tube_radius = millimetre * surface.Torus().MinorRadius();
      return result;
    case GeomAbs_BSplineSurface:
    case GeomAbs_BezierSurface:
    case GeomAbs_SurfaceOfRevolution:
    case GeomAbs_SurfaceOfExtrusion:
      return free_form(face);
    default:
      return result;
  }
}

double tolerance_of(const TopoDS_Face& face) {
  double most = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
    most = std::max(most, BRep_Tool::Tolerance(TopoDS::Edge(edges.Current())));
  for (TopExp_Explorer corners(face, TopAbs_VERTEX); corners.More(); corners.Next())
    most = std::max(most, BRep_Tool::Tolerance(TopoDS::Vertex(corners.Current())));
  return millimetre * most;
}

}  // namespace

surface_geometry geometry_of(const TopoDS_Face& face) {
  auto result = shape_of(face);
  if (result.type != surface_geometry::kind::none)
    result.tolerance = tolerance_of(face);
  return result;
}

}  // namespace tedit::cad
