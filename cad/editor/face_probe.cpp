// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/face_probe.hpp"

#include <algorithm>
#include <cmath>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <BndLib.hxx>
#include <ElSLib.hxx>
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

double face_probe::distance_of_rim(const gp_Pnt& point, double at_most) const {
  const auto vertex = BRepBuilderAPI_MakeVertex(point).Vertex();
  double nearest = at_most;
  for (TopExp_Explorer edges(face_, TopAbs_EDGE); edges.More(); edges.Next()) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(edges.Current())))
      continue;
    const BRepExtrema_DistShapeShape far(vertex, edges.Current());
    if (far.IsDone() && far.NbSolution() > 0)
      nearest = std::min(nearest, far.Value());
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
  return project(point, u, v) ? surface_->Value(u, v).Distance(point) : 1e300;
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
    result.distance = distance_of_rim(point, at_most);
    return result;
  }
  const double off = surface_->Value(u, v).Distance(point);
  if (off >= at_most)
    return result;
  result.curvature = curvature_of(*surface_, u, v);
  result.distance =
    is_inside(u, v) ? off : std::max(off, distance_of_rim(point, at_most) - rim_slack_);
  return result;
}

}  // namespace tedit::cad
