// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/face_probe.hpp"

#include <algorithm>
#include <cmath>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepLProp_CLProps.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <BndLib.hxx>
#include <ElSLib.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace tedit::cad {

namespace {

/// In the parameters of the surface; as OpenCASCADE's own algorithms take it.
constexpr double inside_tolerance = 1e-7;

/// OpenCASCADE's own box of a piece of a torus is too small where its tube's angles begin below 0
/// (BndLib of 7.6 rounds them towards 0): that of the tube all around is right.
void add_tube(const TopoDS_Face& face, Bnd_Box& box) {
  const BRepAdaptor_Surface surface(face, Standard_False);
  if (surface.GetType() != GeomAbs_Torus)
    return;
  Standard_Real u1 = 0;
  Standard_Real u2 = 0;
  Standard_Real v1 = 0;
  Standard_Real v2 = 0;
  BRepTools::UVBounds(face, u1, u2, v1, v2);
  BndLib::Add(surface.Torus(), u1, u2, 0, 2 * M_PI, BRep_Tool::Tolerance(face), box);
}

/// Of an edge, at the point of it that was found; 0 at its ends.
double curvature_of(const TopoDS_Edge& edge, const BRepExtrema_DistShapeShape& found) {
  if (found.SupportTypeShape2(1) != BRepExtrema_IsOnEdge)
    return 0;
  Standard_Real at = 0;
  found.ParOnEdgeS2(1, at);
  const BRepAdaptor_Curve curve(edge);
  BRepLProp_CLProps properties(curve, at, 2, 1e-9);
  return properties.IsTangentDefined() ? properties.Curvature() : 0;
}

}  // namespace

face_probe::face_probe(const TopoDS_Face& face, double rim_slack)
    : face_(face), rim_slack_(rim_slack) {
  // Not AddOptimal: it looks for the best box of a torus or a spline by swarms of particles.
  BRepBndLib::Add(face_, extent_, Standard_False);
  add_tube(face_, extent_);
}

double curvature_of(const BRepAdaptor_Surface& surface, double u, double v) {
  if (surface.GetType() == GeomAbs_Plane)
    return 0;
  BRepLProp_SLProps properties(surface, u, v, 2, 1e-9);
  if (!properties.IsCurvatureDefined())
    return 0;
  return std::max(std::abs(properties.MaxCurvature()), std::abs(properties.MinCurvature()));
}

bool face_probe::project(const gp_Pnt& point, double& u, double& v) {
  switch (surface_->GetType()) {
    case GeomAbs_Plane:
      ElSLib::Parameters(surface_->Plane(), point, u, v);
      return true;
    case GeomAbs_Cylinder:
      ElSLib::Parameters(surface_->Cylinder(), point, u, v);
      return true;
    case GeomAbs_Cone:
      ElSLib::Parameters(surface_->Cone(), point, u, v);
      return true;
    case GeomAbs_Sphere:
      ElSLib::Parameters(surface_->Sphere(), point, u, v);
      return true;
    case GeomAbs_Torus:
      ElSLib::Parameters(surface_->Torus(), point, u, v);
      return true;
    default:
      break;
  }
  if (!projection_) {
    Standard_Real u1 = 0;
    Standard_Real u2 = 0;
    Standard_Real v1 = 0;
    Standard_Real v2 = 0;
    BRepTools::UVBounds(face_, u1, u2, v1, v2);
    projection_ = std::make_unique<GeomAPI_ProjectPointOnSurf>();
    projection_->Init(BRep_Tool::Surface(face_), u1, u2, v1, v2);
  }
  projection_->Perform(point);
  if (projection_->NbPoints() == 0)
    return false;
  projection_->LowerDistanceParameters(u, v);
  return true;
}

bool face_probe::is_inside(double u, double v) {
  if (!inside_)
    inside_ = std::make_unique<BRepTopAdaptor_FClass2d>(face_, inside_tolerance);
  return inside_->Perform(gp_Pnt2d(u, v), Standard_True) != TopAbs_OUT;
}

face_probe::rim_finding face_probe::nearest_rim(const gp_Pnt& point, double at_most) const {
  const auto vertex = BRepBuilderAPI_MakeVertex(point).Vertex();
  rim_finding nearest;
  nearest.distance = at_most;
  for (TopExp_Explorer edges(face_, TopAbs_EDGE); edges.More(); edges.Next()) {
    const auto edge = TopoDS::Edge(edges.Current());
    if (BRep_Tool::Degenerated(edge))
      continue;
    const BRepExtrema_DistShapeShape far(vertex, edge);
    if (!far.IsDone() || far.NbSolution() == 0)
      continue;
    if (far.Value() < nearest.distance) {
      nearest.distance = far.Value();
      nearest.curvature = curvature_of(edge, far);
    }
  }
  return nearest;
}

void face_probe::open() {
  if (!surface_)
    surface_ = std::make_unique<BRepAdaptor_Surface>(face_, Standard_False);
}

double face_probe::distance_of_surface(const gp_Pnt& point) {
  open();
  double u = 0;
  double v = 0;
  if (!project(point, u, v)) {
    const auto end = ShapeAnalysis_Surface(BRep_Tool::Surface(face_)).ValueOfUV(point, 1e-9);
    u = end.X();
    v = end.Y();
  }
  gp_Pnt at;
  gp_Vec along_u;
  gp_Vec along_v;
  surface_->D1(u, v, at, along_u, along_v);
  // Beyond its end free form goes on as its tangent plane there.
  const auto normal = along_u.Crossed(along_v);
  const double size = normal.Magnitude();
  return size > 0 ? std::abs(gp_Vec(at, point).Dot(normal)) / size : at.Distance(point);
}

double face_probe::vague() const {
  double most = 0;
  for (TopExp_Explorer edges(face_, TopAbs_EDGE); edges.More(); edges.Next())
    most = std::max(most, BRep_Tool::Tolerance(TopoDS::Edge(edges.Current())));
  return most;
}

gp_Vec face_probe::outward_at(const gp_Pnt& point) {
  open();
  double u = 0;
  double v = 0;
  if (!project(point, u, v))
    return {};
  gp_Pnt at;
  gp_Vec along_u;
  gp_Vec along_v;
  surface_->D1(u, v, at, along_u, along_v);
  const auto normal = along_u.Crossed(along_v);
  return face_.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

face_probe::finding face_probe::operator()(const gp_Pnt& point, double at_most) {
  finding result;
  result.distance = at_most;
  Bnd_Box around;
  around.Set(point);
  around.Enlarge(at_most);
  if (extent_.IsOut(around))
    return result;
  open();
  double u = 0;
  double v = 0;
  if (!project(point, u, v)) {
    result.distance = nearest_rim(point, at_most).distance;
    return result;
  }
  const double off = surface_->Value(u, v).Distance(point);
  if (off >= at_most)
    return result;
  result.curvature = curvature_of(*surface_, u, v);
  result.distance = off;
  if (is_inside(u, v))
    return result;
  const auto rim = nearest_rim(point, at_most);
  result.distance = std::max(off, rim.distance - rim_slack_);
  result.curvature = std::max(result.curvature, rim.curvature);
  return result;
}

}  // namespace tedit::cad
