// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/slab.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include <BOPAlgo_Splitter.hxx>
#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IntTools_Context.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include "cad/editor/face_probe.hpp"
#include "mesh/vec3.hpp"

namespace tedit::cad {

namespace {

/// The slab begins so much of its height before the wall: a face in the wall's own plane would
/// touch fillets at no angle there.
constexpr double margin = 0.37;
/// Points of a piece that the mesh is asked about: so far in from its faces, in heights of the
/// slab, as far as that is inside.
constexpr std::array depths{0.2, 0.05, 0.01};
constexpr int most_points = 9;
/// Sines of angles to the slab: a face along it does not divide it, one about upright is prolonged
/// (within 30 degrees, as the mesh's tool has it).
constexpr double along_slab = 1e-3;
constexpr double about_upright = 0.866;

/// Where the edited mesh has material.
class mesh_inside {
public:
  mesh_inside(const part_model& part, const edited_surface& mesh) : mesh_(mesh) {
    TopTools_IndexedDataMapOfShapeListOfShape solids;
    TopExp::MapShapesAndAncestors(part.shape, TopAbs_FACE, TopAbs_SOLID, solids);
    for (Standard_Integer i = 1; i <= part.faces.Extent(); ++i)
      if (solids.FindFromKey(part.faces(i)).Extent() > 1) {
        const auto& ids = part.facts.faces[static_cast<std::size_t>(i - 1)].ids;
        between_.insert(ids.begin(), ids.end());
      }
  }

  /// Does the boundary go round p? The solid angle that each triangle takes up there (van Oosterom
  /// and Strackee 1983), over a full one; faces between two solids are no boundary.
  [[nodiscard]] bool operator()(vec3 p) const {
    double sum = 0;
    for (const auto& t : mesh_.triangles) {
      if (t[4] == triangle_gone || between_.contains(t[3]))
        continue;
      const vec3 a = at(t[0]) - p;
      const vec3 b = at(t[1]) - p;
      const vec3 c = at(t[2]) - p;
      const double x = norm(a);
      const double y = norm(b);
      const double z = norm(c);
      sum += 2 * std::atan2(dot(a, cross(b, c)),
                            x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
    }
    return sum > 2 * std::numbers::pi;
  }

private:
  [[nodiscard]] vec3 at(std::int32_t i) const {
    const auto& p = mesh_.points[static_cast<std::size_t>(i)];
    return {p[0], p[1], p[2]};
  }

  const edited_surface& mesh_;
  std::set<int> between_;
};

/// Is most of a piece material of the edited mesh?
bool is_filled(const TopoDS_Shape& piece, double height, const mesh_inside& is_inside) {
  BRepClass3d_SolidClassifier inside(piece);
  const Handle(IntTools_Context) context = new IntTools_Context;
  int asked = 0;
  int filled = 0;
  for (TopExp_Explorer faces(piece, TopAbs_FACE); faces.More() && asked < most_points;
       faces.Next()) {
    const auto face = TopoDS::Face(faces.Current());
    gp_Pnt on;
    gp_Pnt2d uv;
    if (BOPTools_AlgoTools3D::PointInFace(face, on, uv, context) != 0)
      continue;
    face_probe probe(face);
    auto inward = probe.outward_at(on).Reversed();
    if (inward.Magnitude() < 1e-12)
      continue;
    inward.Normalize();
    for (const double depth : depths) {
      const auto p = on.Translated(inward * (depth * height));
      inside.Perform(p, 1e-7);
      if (inside.State() != TopAbs_IN)
        continue;
      ++asked;
      filled += is_inside({p.X(), p.Y(), p.Z()}) ? 1 : 0;
      break;
    }
  }
  return 2 * filled > asked;
}

/// All around the part between the plane of a wall, and a little before it, and that plane moved.
TopoDS_Shape slab_of(const TopoDS_Shape& shape, const TopoDS_Face& wall, double distance) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  const double wide = 2 * std::sqrt(box.SquareExtent());
  const double height = std::abs(distance);
  const auto outward = outward_of_plane(wall);
  const auto way = distance < 0 ? outward.Reversed() : outward;
  gp_Ax2 place(BRepAdaptor_Surface(wall).Plane().Location(), way);
  place.Translate(gp_Vec(place.XDirection()) * -wide / 2 + gp_Vec(place.YDirection()) * -wide / 2 +
                  gp_Vec(way) * -margin * height);
  return BRepPrimAPI_MakeBox(place, wide, wide, (1 + margin) * height).Shape();
}

/// The faces, and those that share an edge with one of them.
TopTools_IndexedMapOfShape with_neighbours(const TopTools_IndexedMapOfShape& faces,
                                           const TopTools_IndexedDataMapOfShapeListOfShape& at) {
  auto all = faces;
  for (Standard_Integer i = 1; i <= faces.Extent(); ++i)
    for (TopExp_Explorer edges(faces(i), TopAbs_EDGE); edges.More(); edges.Next())
      for (const auto& face : at.FindFromKey(edges.Current()))
        all.Add(face);
  return all;
}

/// A straight edge, longer by `more` (mm) at both ends, to planes that lean; another one as it is.
TopoDS_Shape prolonged(const TopoDS_Shape& edge, double more) {
  const BRepAdaptor_Curve curve(TopoDS::Edge(edge));
  if (curve.GetType() != GeomAbs_Line)
    return edge;
  return BRepBuilderAPI_MakeEdge(curve.Line(), curve.FirstParameter() - more,
                                 curve.LastParameter() + more)
    .Shape();
}

/// What an edge passes on its way to the slab's other side, from wherever in it.
TopoDS_Shape upright(const TopoDS_Shape& edge, const gp_Vec& way) {
  gp_Trsf back;
  back.SetTranslation(-way);
  return BRepPrimAPI_MakePrism(edge.Moved(TopLoc_Location(back)), 2 * way).Shape();
}

TopTools_IndexedMapOfShape edges_of(const TopTools_IndexedMapOfShape& faces) {
  TopTools_IndexedMapOfShape edges;
  for (Standard_Integer i = 1; i <= faces.Extent(); ++i)
    TopExp::MapShapes(faces(i), TopAbs_EDGE, edges);
  return edges;
}

/// The sine of the angle between a flat face and the slab; nothing for another face.
std::optional<double> leans_by(const TopoDS_Shape& face, const gp_Vec& way) {
  const BRepAdaptor_Surface surface(TopoDS::Face(face));
  if (surface.GetType() != GeomAbs_Plane)
    return std::nullopt;
  return gp_Vec(surface.Plane().Axis().Direction()).Crossed(way.Normalized()).Magnitude();
}

/// What may divide a slab on a wall of a part.
class divider_finder {
public:
  divider_finder(const TopoDS_Shape& solid, const TopoDS_Face& wall, const gp_Vec& way)
      : wall_(wall), way_(way), at_(faces_at_edges(solid)) {
    Bnd_Box box;
    BRepBndLib::Add(solid, box);
    wide_ = std::sqrt(box.SquareExtent());
    middle_ = gp_Pnt((box.CornerMin().XYZ() + box.CornerMax().XYZ()) / 2);
  }

  [[nodiscard]] std::vector<TopoDS_Shape> find(slab_division by) const {
    TopTools_IndexedMapOfShape own;
    own.Add(wall_);
    const auto beside = with_neighbours(own, at_);
    std::vector<TopoDS_Shape> dividers;
    const auto edges = edges_of(by == slab_division::edges_beyond   ? with_neighbours(beside, at_)
                                : by == slab_division::edges_around ? beside
                                                                    : own);
    const bool by_planes = by == slab_division::planes_around;
    for (Standard_Integer i = 1; i <= edges.Extent(); ++i)
      if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(i))) && !(by_planes && is_prolonged(edges(i))))
        dividers.push_back(
          upright(by_planes ? prolonged(edges(i), way_.Magnitude()) : edges(i), way_));
    if (by_planes)
      add_planes(with_neighbours(beside, at_), dividers);
    return dividers;
  }

private:
  /// Does a plane stand about upright beside the wall there? The mesh prolongs it.
  [[nodiscard]] bool is_prolonged(const TopoDS_Shape& edge) const {
    return std::ranges::any_of(at_.FindFromKey(edge), [&](const TopoDS_Shape& face) {
      return leans_by(face, way_).value_or(0) > about_upright;
    });
  }

  void add_planes(const TopTools_IndexedMapOfShape& faces,
                  std::vector<TopoDS_Shape>& dividers) const {
    for (Standard_Integer i = 1; i <= faces.Extent(); ++i)
      if (leans_by(faces(i), way_).value_or(0) > along_slab) {
        auto plane = BRepAdaptor_Surface(TopoDS::Face(faces(i))).Plane();
        const gp_Vec normal(plane.Axis().Direction());
        plane.SetLocation(
          middle_.Translated(normal * normal.Dot(gp_Vec(middle_, plane.Location()))));
        dividers.push_back(BRepBuilderAPI_MakeFace(plane, -wide_, wide_, -wide_, wide_).Shape());
      }
  }

  const TopoDS_Face& wall_;
  const gp_Vec way_;
  const TopTools_IndexedDataMapOfShapeListOfShape at_;
  double wide_ = 0;  ///< mm: of the part.
  gp_Pnt middle_;
};

/// The pieces of a slab inside the wall's own solid, or outside all, as they may be divided.
std::vector<TopoDS_Shape> pieces_of(const part_model& part, const TopoDS_Shape& own,
                                    const TopoDS_Face& wall, double distance, slab_division by) {
  const auto slab = slab_of(part.shape, wall, distance);
  const auto rest = distance < 0 ? BRepAlgoAPI_Common(slab, own).Shape()
                                 : BRepAlgoAPI_Cut(slab, part.shape).Shape();
  BOPAlgo_Splitter splitter;
  for (const auto& piece : solids_of(rest))
    splitter.AddArgument(piece);
  const gp_Vec way = gp_Vec(outward_of_plane(wall)) * distance;
  for (const auto& one : divider_finder(own, wall, way).find(by))
    splitter.AddTool(one);
  splitter.SetNonDestructive(true);
  splitter.Perform();
  return splitter.HasErrors() ? std::vector<TopoDS_Shape>() : solids_of(splitter.Shape());
}

/// Null where that is none, or two.
TopoDS_Shape owner_of_all(const part_model& part, const std::vector<TopoDS_Face>& walls) {
  TopTools_IndexedDataMapOfShapeListOfShape solids;
  TopExp::MapShapesAndAncestors(part.shape, TopAbs_FACE, TopAbs_SOLID, solids);
  TopoDS_Shape owner;
  for (const auto& wall : walls)
    for (const auto& solid : solids.FindFromKey(wall)) {
      if (!owner.IsNull() && !owner.IsSame(solid))
        return {};
      owner = solid;
    }
  return owner;
}

}  // namespace

TopoDS_Shape moved_by_slab(const part_model& part, const std::vector<TopoDS_Face>& walls,
                           double distance_mm, slab_division by, const edited_surface& mesh) {
  const auto own = owner_of_all(part, walls);
  if (own.IsNull())
    return {};
  const mesh_inside is_inside(part, mesh);
  std::vector<TopoDS_Shape> changed;
  for (const auto& wall : walls)
    for (const auto& piece : pieces_of(part, own, wall, distance_mm, by))
      if (is_filled(piece, std::abs(distance_mm), is_inside) == (distance_mm > 0))
        changed.push_back(piece);
  return changed.empty()
           ? TopoDS_Shape()
           : combined(
               part, changed, distance_mm > 0 ? body_operation::add : body_operation::cut,
               [&](const TopoDS_Shape& solid) { return solid.IsSame(own); },
               new_edges::go_across_simple);
}

}  // namespace tedit::cad
