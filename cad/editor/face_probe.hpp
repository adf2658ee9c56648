// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace tedit::cad {

/// The larger one of a surface's curvatures, 1/mm; 0 where it has none.
[[nodiscard]] double curvature_of(const BRepAdaptor_Surface& surface, double u, double v);

/// Where points are with regard to one face. What it needs is made when it is first asked for.
class face_probe {
public:
  /// @param rim_slack mm: a point of the face's surface that is so near to its rim is on the face.
  /// Where two faces touch smoothly, a gap of a nanometre between them moves their edge by
  /// micrometres: what the surfaces say is exact, where they end is not.
  explicit face_probe(const TopoDS_Face& face, double rim_slack = 0);

  [[nodiscard]] const TopoDS_Face& face() const { return face_; }
  [[nodiscard]] const Bnd_Box& extent() const { return extent_; }

  struct finding {
    double distance = 1e300;  ///< mm, of the nearest point of the face, or `at_most`.
    double curvature = 0;  ///< 1/mm: the larger one of the surface there, or of the rim before it.
  };

  /// Looked for up to `at_most` (mm): beyond it only that is said.
  [[nodiscard]] finding operator()(const gp_Pnt& point, double at_most);

  /// mm: so far may the model's own edges of the face be off it.
  [[nodiscard]] double vague() const;

  /// mm: of the surface that the face is a piece of.
  [[nodiscard]] double distance_of_surface(const gp_Pnt& point);

  /// Out of the material, at the point of the surface below `point`; null where that is none.
  [[nodiscard]] gp_Vec outward_at(const gp_Pnt& point);

private:
  void open();
  [[nodiscard]] bool project(const gp_Pnt& point, double& u, double& v);
  [[nodiscard]] bool is_inside(double u, double v);

  struct rim_finding {
    double distance = 0;   ///< mm
    double curvature = 0;  ///< 1/mm
  };
  [[nodiscard]] rim_finding nearest_rim(const gp_Pnt& point, double at_most) const;

  TopoDS_Face face_;
  double rim_slack_ = 0;
  Bnd_Box extent_;
  std::unique_ptr<BRepAdaptor_Surface> surface_;
  std::unique_ptr<BRepTopAdaptor_FClass2d> inside_;
  std::unique_ptr<GeomAPI_ProjectPointOnSurf> projection_;
};

}  // namespace tedit::cad
