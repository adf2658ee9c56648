// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/moved_surfaces.hpp"

#include <algorithm>
#include <cmath>

#include <BRep_Tool.hxx>
#include <GeomAPI_IntSS.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace tedit::cad {

namespace {

/// What a place may be off the surfaces that meet there, as a share of the part's size; an edge
/// that a file leaves open between its faces is further off them than rounding.
constexpr double place_share = 1e-9;
constexpr double edge_share = 1e-6;
/// Surfaces that meet at less than this sine say the same of a place; as in the mesh.
constexpr double least_sine = 0.05;
constexpr int newton_steps = 30;

Handle(Geom_Surface) bare(Handle(Geom_Surface) surface) {
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  return surface;
}

Handle(Geom_Curve) bare(Handle(Geom_Curve) curve) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
    curve = trimmed->BasisCurve();
  return curve;
}

/// The nearest point of a surface, and its unit normal there.
struct foot {
  gp_Pnt at;
  gp_Vec normal;
};

foot foot_of(const Handle(Geom_Surface) & surface, const gp_Pnt& p) {
  ShapeAnalysis_Surface probe(surface);
  const auto uv = probe.ValueOfUV(p, 1e-9);
  foot found;
  gp_Vec along_u;
  gp_Vec along_v;
  surface->D1(uv.X(), uv.Y(), found.at, along_u, along_v);
  found.normal = along_u.Crossed(along_v);
  if (found.normal.Magnitude() < 1e-12)
    throw nowhere();
  found.normal.Normalize();
  return found;
}

Handle(Geom_Surface) surface_of(const TopoDS_Shape& face) {
  return bare(BRep_Tool::Surface(TopoDS::Face(face)));
}

double distance_of(const Handle(Geom_Curve) & curve, const gp_Pnt& p) {
  const GeomAPI_ProjectPointOnCurve near(p, curve);
  return near.NbPoints() > 0 ? near.LowerDistance() : 1e300;
}

}  // namespace

moved_surfaces::moved_surfaces(const part_model& part, const cad_step& step)
    : part_(part), step_(step), size_(step.size_mm) {
  std::vector<int> walls = step.surfaces;
  for (const auto& c : step.carried) {
    std::erase(walls, c.surface);
    const gp_Vec way(c.way_mm[0], c.way_mm[1], c.way_mm[2]);
    for (const auto& face : part.faces_of({c.surface}))
      add(face, {Handle(Geom_Surface)::DownCast(surface_of(face)->Translated(way)), way, false});
  }
  for (const auto& face : part.faces_of(walls))
    if (!add_wall(face)) {
      surfaces_.clear();
      return;
    }
}

void moved_surfaces::add(const TopoDS_Face& face, row one) {
  if (moving_.Contains(face))
    return;
  surfaces_.emplace_back(std::move(one));
  moving_.Add(face);
}

bool moved_surfaces::add_wall(const TopoDS_Face& face) {
  const auto before = surface_of(face);
  const Handle(Geom_OffsetSurface) offset = new Geom_OffsetSurface(before, outward(face));
  const auto after = bare(offset->Surface());
  if (after.IsNull())
    return false;
  row one{after, {}, true};
  if (const auto plane = Handle(Geom_Plane)::DownCast(after))
    one.way = gp_Vec(Handle(Geom_Plane)::DownCast(before)->Location(), plane->Location());
  add(face, one);
  return true;
}

/// mm along the surface's own normal.
double moved_surfaces::outward(const TopoDS_Face& face) const {
  for (TopExp_Explorer all(part_.shape, TopAbs_FACE); all.More(); all.Next())
    if (all.Current().IsSame(face))
      return all.Current().Orientation() == TopAbs_REVERSED ? -step_.distance_mm
                                                            : step_.distance_mm;
  return 0;
}

const moved_surfaces::row* moved_surfaces::row_of(const TopoDS_Shape& face) const {
  const auto i = moving_.FindIndex(face);
  return i > 0 ? &surfaces_[static_cast<std::size_t>(i - 1)] : nullptr;
}

Handle(Geom_Surface) moved_surfaces::after(const TopoDS_Shape& face) const {
  const auto* one = row_of(face);
  return one ? one->after : surface_of(face);
}

std::vector<TopoDS_Shape> moved_surfaces::faces_around(const TopTools_ListOfShape& all) const {
  TopTools_IndexedMapOfShape once;
  for (const bool moving : {true, false})
    for (const auto& face : all)
      if (moves(face) == moving)
        once.Add(face);
  std::vector<TopoDS_Shape> faces;
  for (Standard_Integer i = 1; i <= once.Extent(); ++i)
    faces.push_back(once(i));
  return faces;
}

gp_Pnt moved_surfaces::place_of(const gp_Pnt& start, const std::vector<TopoDS_Shape>& faces,
                                const std::vector<gp_Vec>& aside) const {
  gp_Pnt at = start;
  for (const auto& face : faces) {
    const auto* one = row_of(face);
    if (!one || !one->way)
      continue;
    const auto shifted = start.Translated(*one->way);
    // Where faces touch smoothly their normals say nothing of the way between them.
    if (is_on_all(shifted, faces))
      return shifted;
    if (!one->is_wall || at.IsEqual(start, 0))
      at = shifted;
  }
  for (int n = 0; n < newton_steps; ++n) {
    const auto step = newton_step(faces, at, aside);
    at.Translate(step);
    if (step.Magnitude() < 1e-3 * place_share * size_)
      break;
  }
  if (!is_on_all(at, faces))
    throw nowhere();
  return at;
}

gp_Vec moved_surfaces::newton_step(const std::vector<TopoDS_Shape>& faces, const gp_Pnt& at,
                                   const std::vector<gp_Vec>& aside) const {
  std::vector<gp_Vec> basis;
  gp_Vec step(0, 0, 0);
  const auto go = [&](const gp_Vec& way, double by) {
    gp_Vec rest = way;
    for (const auto& b : basis)
      rest -= b * rest.Dot(b);
    const double size = rest.Magnitude();
    if (size < least_sine || basis.size() == 3)
      return;
    basis.push_back(rest / size);
    step += basis.back() * ((by - way.Dot(step)) / size);
  };
  for (const auto& way : aside)
    go(way, 0);
  for (const auto& face : faces) {
    const auto below = foot_of(after(face), at);
    go(below.normal, below.normal.Dot(gp_Vec(at, below.at)));
  }
  return step;
}

std::optional<gp_Vec> moved_surfaces::aside_of(const gp_Pnt& at, const gp_Vec& along,
                                               const std::vector<TopoDS_Shape>& faces) const {
  if (faces.size() != 2)
    return std::nullopt;
  const auto one = foot_of(surface_of(faces[0]), at).normal;
  const auto other = foot_of(surface_of(faces[1]), at).normal;
  const auto aside = one.Crossed(along);
  if (one.Crossed(other).Magnitude() >= least_sine || aside.Magnitude() < 1e-12)
    return std::nullopt;
  return aside.Normalized();
}

bool moved_surfaces::is_same(const gp_Pnt& one, const gp_Pnt& other) const {
  return one.IsEqual(other, place_share * size_);
}

bool moved_surfaces::is_on_all(const gp_Pnt& p, const std::vector<TopoDS_Shape>& faces) const {
  return std::ranges::all_of(faces, [&](const TopoDS_Shape& face) {
    return foot_of(after(face), p).at.Distance(p) <= edge_share * size_;
  });
}

bool moved_surfaces::is_on_all(const Handle(Geom_Curve) & curve, double from, double to,
                               const std::vector<TopoDS_Shape>& faces) const {
  constexpr int samples = 5;
  for (int i = 0; i <= samples; ++i)
    if (!is_on_all(curve->Value(from + (to - from) * i / samples), faces))
      return false;
  return true;
}

Handle(Geom_Curve) moved_surfaces::curve_of(const Handle(Geom_Curve) & before, double from,
                                            double to, const std::vector<TopoDS_Shape>& faces,
                                            const std::array<gp_Pnt, 2>& ends) const {
  const auto own = bare(before);
  if (!moves(faces.front()))
    return own;
  for (const auto& face : faces)
    if (const auto* one = row_of(face); one && one->way) {
      const auto shifted = Handle(Geom_Curve)::DownCast(own->Translated(*one->way));
      if (is_on_all(shifted, from, to, faces))
        return shifted;
    }
  // A seam, or where halves of one bore meet.
  const auto along = seam_of(faces.front(), own->Value(from), own->Value(0.5 * (from + to)));
  if (faces.size() == 1 || is_on_all(along, from, to, faces))
    return along;
  return meeting_of(after(faces[0]), after(faces[1]), ends);
}

/// A seam runs along a parameter line of its surface, as offset.
Handle(Geom_Curve) moved_surfaces::seam_of(const TopoDS_Shape& face, const gp_Pnt& a,
                                           const gp_Pnt& b) const {
  ShapeAnalysis_Surface probe(surface_of(face));
  const auto one = probe.ValueOfUV(a, 1e-9);
  const auto other = probe.ValueOfUV(b, 1e-9);
  const double du = std::abs(one.X() - other.X());
  constexpr double same_line = 1e-6;
  const bool is_u = du < same_line || std::abs(du - 2 * M_PI) < same_line;
  return bare(is_u ? after(face)->UIso(one.X()) : after(face)->VIso(one.Y()));
}

Handle(Geom_Curve) moved_surfaces::meeting_of(const Handle(Geom_Surface) & one,
                                              const Handle(Geom_Surface) & other,
                                              const std::array<gp_Pnt, 2>& ends) const {
  const GeomAPI_IntSS meeting(one, other, 1e-7);
  Handle(Geom_Curve) best;
  double least = edge_share * size_;
  for (int i = 1; meeting.IsDone() && i <= meeting.NbLines(); ++i) {
    const auto curve = bare(meeting.Line(i));
    const double far = std::max(distance_of(curve, ends[0]), distance_of(curve, ends[1]));
    if (far < least) {
      least = far;
      best = curve;
    }
  }
  if (best.IsNull())
    throw nowhere();
  return best;
}

double moved_surfaces::parameter_of(const Handle(Geom_Curve) & curve, const gp_Pnt& p) const {
  const GeomAPI_ProjectPointOnCurve near(p, curve);
  if (near.NbPoints() == 0 || near.LowerDistance() > edge_share * size_)
    throw nowhere();
  return near.LowerDistanceParameter();
}

}  // namespace tedit::cad
