// SPDX-License-Identifier: AGPL-3.0-or-later
// Where surfaces, vertices and edges are when walls have moved.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "cad/editor/part.hpp"

namespace tedit::cad {

/// Thrown where an edge or a vertex finds no place: it would vanish, or its surfaces end.
struct nowhere {};

/// What the walls of a `shift` and the surfaces that go along are then. The part must outlive it.
class moved_surfaces {
public:
  moved_surfaces(const part_model& part, const cad_step& step);

  /// None: a wall has no exact shape, so that the mesh moves it point by point.
  [[nodiscard]] bool empty() const { return surfaces_.empty(); }

  [[nodiscard]] bool moves(const TopoDS_Shape& face) const { return row_of(face) != nullptr; }

  /// The surface behind a face then.
  [[nodiscard]] Handle(Geom_Surface) after(const TopoDS_Shape& face) const;

  /// Each face once; those that move first.
  [[nodiscard]] std::vector<TopoDS_Shape> faces_around(const TopTools_ListOfShape& all) const;

  /// Where the surfaces around a vertex, of which one moves, meet then, by the shortest steps from
  /// where it was. Throws
  /// `nowhere`. Cost: a projection on each of them some times.
  /// @param aside unit: ways that the vertex does not go (`aside_of`), but with what is shifted.
  [[nodiscard]] gp_Pnt place_of(const gp_Pnt& start, const std::vector<TopoDS_Shape>& faces,
                                const std::vector<gp_Vec>& aside) const;

  /// Across an edge in which two faces touch smoothly, in both: what they are says nothing of that
  /// way. None of another edge. Cost: O(1).
  [[nodiscard]] std::optional<gp_Vec> aside_of(const gp_Pnt& at, const gp_Vec& along,
                                               const std::vector<TopoDS_Shape>& faces) const;

  /// The curve of an edge where its surfaces are then, through its ends; not yet which way it runs.
  /// Throws `nowhere`. Cost: an intersection of two surfaces at most.
  [[nodiscard]] Handle(Geom_Curve)
    curve_of(const Handle(Geom_Curve) & before, double from, double to,
             const std::vector<TopoDS_Shape>& faces, const std::array<gp_Pnt, 2>& ends) const;

  /// Where a point is on a curve. Throws `nowhere` for one that is off it.
  [[nodiscard]] double parameter_of(const Handle(Geom_Curve) & curve, const gp_Pnt& p) const;

  /// Is a place the same as before?
  [[nodiscard]] bool is_same(const gp_Pnt& one, const gp_Pnt& other) const;

private:
  /// A surface that moves.
  struct row {
    Handle(Geom_Surface) after;
    std::optional<gp_Vec> way;  ///< Where it is shifted as a whole.
    bool is_wall = false;
  };

  void add(const TopoDS_Face& face, row one);
  bool add_wall(const TopoDS_Face& face);
  [[nodiscard]] const row* row_of(const TopoDS_Shape& face) const;
  [[nodiscard]] double outward(const TopoDS_Face& face) const;
  [[nodiscard]] gp_Vec newton_step(const std::vector<TopoDS_Shape>& faces, const gp_Pnt& at,
                                   const std::vector<gp_Vec>& aside) const;
  [[nodiscard]] bool is_on_all(const gp_Pnt& p, const std::vector<TopoDS_Shape>& faces) const;
  [[nodiscard]] bool is_on_all(const Handle(Geom_Curve) & curve, double from, double to,
                               const std::vector<TopoDS_Shape>& faces) const;
  [[nodiscard]] Handle(Geom_Curve)
    seam_of(const TopoDS_Shape& face, const gp_Pnt& a, const gp_Pnt& b) const;
  [[nodiscard]] Handle(Geom_Curve)
    meeting_of(const Handle(Geom_Surface) & one, const Handle(Geom_Surface) & other,
               const std::array<gp_Pnt, 2>& ends) const;

  const part_model& part_;
  const cad_step& step_;
  const double size_;
  TopTools_IndexedMapOfShape moving_;  ///< Faces, from 1.
  std::vector<row> surfaces_;
};

}  // namespace tedit::cad
