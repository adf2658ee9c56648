// SPDX-License-Identifier: AGPL-3.0-or-later
// Holes and bosses that are made again elsewhere, of their own faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Lin.hxx>
#include <gp_Trsf.hxx>

#include "cad/editor/feature.hpp"
#include "mesh/features/lid_way.hpp"

#ifdef __SANITIZE_ADDRESS__
/// OpenCASCADE 7.6 gives back with `delete` what IntCurvesFace_ShapeIntersector has from `new[]`.
extern "C" [[gnu::visibility("default")]] const char* __asan_default_options() {
  return "alloc_dealloc_mismatch=0";
}
#endif

namespace tedit::cad {

namespace {

gp_Trsf transformation(const step_motion& way) {
  const auto& c = way.columns;
  gp_Trsf result;
  result.SetValues(c[0][0], c[1][0], c[2][0], way.shift[0],  //
                   c[0][1], c[1][1], c[2][1], way.shift[1],  //
                   c[0][2], c[1][2], c[2][2], way.shift[2]);
  return result;
}

using chord = std::array<gp_Pnt, 2>;

/// What closes a feature, and which way is out of its body.
struct feature_lid {
  TopoDS_Face cap;
  gp_Vec outward;  ///< Unit.
  gp_Vec way;      ///< Unit: which way the walls go on, where they all go one way; else outward.
  std::vector<chord> rim;
};

/// Twelve of each edge.
std::vector<chord> rim_of(const TopoDS_Face& cap) {
  constexpr int an_edge = 12;
  std::vector<chord> chords;
  for (TopExp_Explorer edges(cap, TopAbs_EDGE); edges.More(); edges.Next()) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(edges.Current())))
      continue;
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges.Current()));
    const double from = curve.FirstParameter();
    const double step = (curve.LastParameter() - from) / an_edge;
    for (int i = 0; i < an_edge; ++i)
      chords.push_back({curve.Value(from + step * i), curve.Value(from + step * (i + 1))});
  }
  return chords;
}

feature_lid lid_of(const TopoDS_Face& cap, const TopoDS_Shape& body, double near) {
  Standard_Real u1 = 0;
  Standard_Real u2 = 0;
  Standard_Real v1 = 0;
  Standard_Real v2 = 0;
  BRepTools::UVBounds(cap, u1, u2, v1, v2);
  gp_Pnt at;
  gp_Vec u;
  gp_Vec v;
  BRepAdaptor_Surface(cap).D1((u1 + u2) / 2, (v1 + v2) / 2, at, u, v);
  feature_lid result{cap, u.Crossed(v).Normalized(), {}, rim_of(cap)};
  // By a point beside the rim, which is inside on one side: the middle may be in a hole of the cap.
  int inside = 0;
  for (const auto& solid : solids_of(body))
    for (const auto& one : result.rim) {
      const gp_Pnt beside = one[0].Translated(gp_Vec(one[0], at) * 1e-2);
      BRepClass3d_SolidClassifier where(solid);
      where.Perform(beside.Translated(result.outward * near), near * 1e-3);
      inside += where.State() == TopAbs_IN ? 1 : 0;
      where.Perform(beside.Translated(result.outward * -near), near * 1e-3);
      inside -= where.State() == TopAbs_IN ? 1 : 0;
    }
  if (inside > 0)
    result.outward.Reverse();
  return result;
}

vec3 xyz(const gp_XYZ& p) {
  return {p.X(), p.Y(), p.Z()};
}

/// As far as `way_past_lid` asks.
surface_geometry wall_of(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face);
  surface_geometry wall;
  if (surface.GetType() == GeomAbs_Plane) {
    wall.type = surface_geometry::kind::plane;
    wall.axis = xyz(surface.Plane().Axis().Direction().XYZ());
  } else if (surface.GetType() == GeomAbs_Cylinder) {
    wall.type = surface_geometry::kind::cylinder;
    wall.axis = xyz(surface.Cylinder().Axis().Direction().XYZ());
  }
  return wall;
}

gp_Vec way_of(const feature_lid& lid, const feature& what) {
  TopTools_IndexedMapOfShape edges_of_lid;
  TopExp::MapShapes(lid.cap, TopAbs_EDGE, edges_of_lid);
  std::vector<surface_geometry> walls;
  for (const auto& face : what.faces)
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
      if (edges_of_lid.Contains(edges.Current())) {
        walls.push_back(wall_of(face));
        break;
      }
  std::vector<std::array<vec3, 2>> rim;
  for (const auto& one : lid.rim)
    rim.push_back({xyz(one[0].XYZ()), xyz(one[1].XYZ())});
  const vec3 way = way_past_lid(walls, xyz(lid.outward.XYZ()), rim);
  return {way.x, way.y, way.z};
}

/// Where a ray first meets the part.
struct first_hit {
  double distance = -1;  ///< Below 0: nowhere.
  bool leaves = false;   ///< The material ends there.
};

first_hit along(IntCurvesFace_ShapeIntersector& part, const gp_Pnt& from, const gp_Vec& way,
                double least) {
  part.PerformNearest(gp_Lin(from, gp_Dir(way)), least, 1e300);
  if (!part.IsDone() || part.NbPnt() == 0)
    return {};
  return {part.WParameter(1), part.Transition(1) == IntCurveSurface_Out};
}

/// All of them ahead, ascending; where it only touches the part there is none.
std::vector<lid_hit> hits_along(IntCurvesFace_ShapeIntersector& part, const gp_Pnt& from,
                                const gp_Vec& way, double least) {
  part.Perform(gp_Lin(from, gp_Dir(way)), least, 1e300);
  std::vector<lid_hit> hits;
  if (!part.IsDone())
    return hits;
  for (int i = 1; i <= part.NbPnt(); ++i)
    if (const auto how = part.Transition(i);
        how == IntCurveSurface_Out || how == IntCurveSurface_In)
      hits.push_back({part.WParameter(i), how == IntCurveSurface_Out});
  std::ranges::sort(hits, {}, &lid_hit::distance);
  return hits;
}

/// A hole reaches out of the part, a boss down to it.
double layer_on(IntCurvesFace_ShapeIntersector& part, const feature_lid& lid, const gp_Trsf& way,
                const cad_step& step) {
  const gp_Vec normal = lid.way.Transformed(way);
  double most = 0;
  gp_XYZ middle;
  for (const auto& one : lid.rim)
    middle += one[0].XYZ() / static_cast<double>(lid.rim.size());
  std::vector<std::vector<lid_hit>> rays;
  for (const auto& one : lid.rim) {
    const auto from =
      gp_Pnt(one[0].XYZ() + lid_rules::within_rim * (middle - one[0].XYZ())).Transformed(way);
    if (step.is_hole) {
      rays.push_back(hits_along(part, from, normal, 1e-9 * step.size_mm));
      continue;
    }
    const auto back = 0.1 * lid_rules::on_surface * step.edge_mm;
    const auto hit = along(part, from.Translated(normal * -back), normal, 1e-9 * step.size_mm);
    if (hit.distance > 0 && !hit.leaves && hit.distance < 0.5 * step.size_mm)
      most = std::max(most, hit.distance);
  }
  if (step.is_hole)
    return reach_of_hole(rays, step.edge_mm);
  return most > lid_rules::on_surface * step.edge_mm ? most + lid_rules::into_part * step.edge_mm
                                                     : 0;
}

/// The copies on what is left of the part.
TopoDS_Shape with_copies(const TopoDS_Shape& rest, const feature& what, const cad_step& step) {
  const auto body = plug_of(what);
  if (rest.IsNull() || body.solids.IsNull())
    return {};
  std::vector<feature_lid> lids;
  for (const auto& cap : body.caps) {
    auto& lid = lids.emplace_back(lid_of(cap, body.solids, 1e-5 * step.size_mm));
    lid.way = way_of(lid, what);
  }
  IntCurvesFace_ShapeIntersector rays;
  rays.Load(rest, 1e-9 * step.size_mm);
  std::vector<TopoDS_Shape> tools;
  for (const auto& motion : step.motions) {
    const auto way = transformation(motion);
    for (const auto& solid : solids_of(body.solids))
      tools.push_back(BRepBuilderAPI_Transform(solid, way, Standard_True).Shape());
    for (const auto& lid : lids)
      if (const double layer = layer_on(rays, lid, way, step); layer > 0)
        tools.push_back(
          BRepPrimAPI_MakePrism(BRepBuilderAPI_Transform(lid.cap, way, Standard_True).Shape(),
                                lid.way.Transformed(way) * layer)
            .Shape());
  }
  part_model base;
  base.shape = rest;
  TopExp::MapShapes(rest, TopAbs_FACE, base.faces);
  return combined(base, tools, step.is_hole ? body_operation::cut : body_operation::add, {},
                  new_edges::stay);
}

}  // namespace

std::vector<way> ways_to_copy(const part_model& part, const cad_step& step) {
  const auto what = std::make_shared<feature>(feature_of(part, step.surfaces));
  if (what->faces.empty())
    return {};
  if (!step.leaves)
    return {
      {"its own faces", [&part, &step, what] { return with_copies(part.shape, *what, step); }}};
  std::vector<way> ways;
  for (const auto& removal : ways_to_remove(
         part, step.surfaces, step.is_hole ? body_operation::add : body_operation::cut))
    ways.push_back({removal.name + ", its own faces",
                    [&step, what, removal] { return with_copies(removal.make(), *what, step); }});
  return ways;
}

}  // namespace tedit::cad
