// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/editor/judge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <BRepCheck_Analyzer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "cad/editor/face_probe.hpp"
#include "cad/editor/face_samples.hpp"
#include "cad/editor/measure_solids.hpp"
#include "cad/editor/ways.hpp"
#include "mesh/distances.hpp"
#include "mesh/facet_distance.hpp"

namespace tedit::cad {

namespace {

using triangle = std::array<gp_Pnt, 3>;

/// A vertex may be beyond its face's rim by so many times what it may be off a surface. Where it is
/// off the face that begins at that rim, the check against that one tells.
constexpr double rim_share = 10;
/// What edges of the model may be off its faces, in the same terms.
constexpr double seam_share = 100;
/// How far beyond the rim, where another face goes on there without a bend: surfaces that touch say
/// only roughly where they do.
constexpr double smooth_share = 500;

/// Cosine: a triangle of a face bends away from it by less.
constexpr double least_along = 0.3;

/// An arc of this chord is at most so far from it, with room for what is not a circle.
double sagitta(double chord, double curvature) {
  return 0.25 * chord * chord * curvature;
}

double longest_edge(const triangle& t) {
  return std::max({t[0].Distance(t[1]), t[1].Distance(t[2]), t[2].Distance(t[0])});
}

gp_Pnt middle_of(const triangle& t) {
  return gp_Pnt((t[0].XYZ() + t[1].XYZ() + t[2].XYZ()) / 3);
}

double area_of(const triangle& t) {
  return 0.5 * gp_Vec(t[0], t[1]).Crossed(gp_Vec(t[0], t[2])).Magnitude();
}

std::string mm(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g mm", value);
  return text;
}

std::string place(const gp_Pnt& p) {
  char text[96];
  std::snprintf(text, sizeof(text), "%.4g, %.4g, %.4g mm", p.X(), p.Y(), p.Z());
  return text;
}

class comparison {
public:
  comparison(const part_model& before, const TopoDS_Shape& after, const cad_step& step,
             const edited_surface& mesh)
      : before_(before), step_(step), mesh_(mesh), tolerance_(vertex_share * step.size_mm) {
    result_.part.shape = after;
    TopExp::MapShapes(after, TopAbs_FACE, result_.part.faces);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
      if (mesh_.triangles[i][4] != triangle_gone)
        triangles_of_[mesh_.triangles[i][3]].push_back(i);
  }

  judgement run() {
    check_validity();
    if (result_.fault.empty())
      name_faces();
    if (result_.fault.empty())
      check_vertices();
    if (result_.fault.empty())
      check_triangles();
    if (result_.fault.empty())
      check_faces();
    if (result_.fault.empty())
      check_volume();
    if (result_.fault.empty())
      measure_solids(before_, result_.part);
    return std::move(result_);
  }

private:
  void check_validity() {
    const auto solids = solids_of(result_.part.shape);
    if (solids.size() != before_.facts.solids.size() && step_.kind != step_kind::split)
      result_.fault = "it has " + std::to_string(solids.size()) + " solids, the model before " +
                      std::to_string(before_.facts.solids.size());
    else if (solids.size() != step_.bodies)
      result_.fault = "it has " + std::to_string(solids.size()) + " solids, the mesh " +
                      std::to_string(step_.bodies) + " bodies";
    else if (!BRepCheck_Analyzer(result_.part.shape).IsValid())
      result_.fault = "it is not valid by OpenCASCADE's checks";
  }

  [[nodiscard]] triangle corners(std::size_t i) const {
    triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = mesh_.points[static_cast<std::size_t>(mesh_.triangles[i][k])];
      t[k] = gp_Pnt(p[0], p[1], p[2]);
    }
    return t;
  }

  /// Does a triangle lie on the face, as a chord does on an arc?
  static bool lies_on(const triangle& t, face_probe& face, double near) {
    for (const auto& corner : t)
      if (face(corner, near).distance >= near)
        return false;
    const double far = std::max(near, 0.5 * longest_edge(t));
    const auto middle = face(middle_of(t), far);
    return middle.distance <= near + sagitta(longest_edge(t), middle.curvature) &&
           lies_along(t, face);
  }

  /// A triangle between three points of a round rim has its corners on both of the faces that meet
  /// there, and is of one.
  static bool lies_along(const triangle& t, face_probe& face) {
    const auto normal = gp_Vec(t[0], t[1]).Crossed(gp_Vec(t[0], t[2]));
    const auto outward = face.outward_at(middle_of(t));
    return std::abs(normal.Dot(outward)) >= least_along * normal.Magnitude() * outward.Magnitude();
  }

  /// Do some of a surface's triangles lie on a face? Looks at a few of those in its box.
  bool is_on(const std::vector<std::size_t>& triangles, face_probe& face) const {
    std::vector<std::size_t> inside;
    for (const auto i : triangles) {
      Bnd_Box one;
      one.Set(middle_of(corners(i)));
      one.Enlarge(tolerance_);
      if (!face.extent().IsOut(one))
        inside.push_back(i);
    }
    constexpr std::size_t few = 24;
    const std::size_t step = std::max<std::size_t>(1, inside.size() / few);
    const double near = 100 * tolerance_;  // What was repaired at import may be off a little.
    for (std::size_t k = 0; k < inside.size(); k += step)
      if (lies_on(corners(inside[k]), face, near) && may_be_of(corners(inside[k]), face))
        return true;
    return false;
  }

  /// Where a part is split two faces lie in one place: they look away from each other.
  [[nodiscard]] bool may_be_of(const triangle& t, face_probe& face) const {
    return step_.kind != step_kind::split ||
           gp_Vec(t[0], t[1]).Crossed(gp_Vec(t[0], t[2])).Dot(face.outward_at(middle_of(t))) > 0;
  }

  /// A row of facts for each face: what was known of it, or what the mesh says it is.
  void name_faces() {
    std::map<int, const face_facts*> known;
    for (const auto& row : before_.facts.faces)
      for (const int id : row.ids)
        known.emplace(id, &row);
    auto& facts = result_.part.facts;
    facts = before_.facts;
    facts.faces.clear();
    const auto& faces = result_.part.faces;
    for (Standard_Integer i = 1; i <= faces.Extent() && result_.fault.empty(); ++i) {
      probes_.emplace_back(TopoDS::Face(faces(i)), rim_share * tolerance_);
      const auto old = before_.faces.FindIndex(faces(i));
      is_new_.push_back(old == 0);
      facts.faces.push_back(old > 0 ? before_.facts.faces[static_cast<std::size_t>(old - 1)]
                                    : facts_of(probes_.back(), known));
      auto& row = facts.faces.back();
      std::erase_if(row.ids, [&](int id) { return !triangles_of_.contains(id); });
      for (const int id : row.ids)
        probes_of_[id].push_back(probes_.size() - 1);
      if (row.ids.empty() && !(old > 0 && is_unmeshed(old)))
        result_.fault = "a face of it, around " + place(middle_of_box(probes_.back())) +
                        ", is nowhere in the mesh";
    }
    for (const auto& [id, triangles] : triangles_of_)
      if (result_.fault.empty() && !probes_of_.contains(id) &&
          (known.contains(id) || has_new(triangles)))
        result_.fault = "surface " + std::to_string(id) + " of the mesh is no face of it";
  }

  /// Of a face that was in no mesh, as it was too small to be meshed.
  [[nodiscard]] bool is_unmeshed(Standard_Integer old) const {
    return before_.facts.faces[static_cast<std::size_t>(old - 1)].ids.empty();
  }

  static gp_Pnt middle_of_box(const face_probe& probe) {
    const auto& box = probe.extent();
    return gp_Pnt((box.CornerMin().XYZ() + box.CornerMax().XYZ()) / 2);
  }

  [[nodiscard]] bool has_new(const std::vector<std::size_t>& triangles) const {
    return std::ranges::any_of(
      triangles, [&](std::size_t i) { return mesh_.triangles[i][4] == triangle_made; });
  }

  /// The surfaces that have triangles near points of a face with corners on the surface that it is
  /// a piece of: also where an edge that the mesh does not know runs across it.
  std::set<int> nearest_surfaces(face_probe& probe) const {
    std::vector<std::size_t> pieces;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      Bnd_Box one;
      for (const auto& corner : corners(i))
        one.Add(corner);
      one.Enlarge(0.5 * longest_edge(corners(i)));
      if (mesh_.triangles[i][4] != triangle_gone && !probe.extent().IsOut(one) &&
          is_piece_of(corners(i), probe) && may_be_of(corners(i), probe))
        pieces.push_back(i);
    }
    std::set<int> ids;
    for (const auto& sample : samples_of(probe.face(), step_.size_mm)) {
      std::size_t best = mesh_.triangles.size();
      double least = step_.size_mm;
      for (const auto i : pieces)
        if (const double far = distance(sample.at, corners(i));
            far <
            std::min(least, tolerance_ + sagitta(longest_edge(corners(i)), sample.curvature))) {
          least = far;
          best = i;
        }
      if (best < mesh_.triangles.size())
        ids.insert(mesh_.triangles[best][3]);
    }
    return ids;
  }

  [[nodiscard]] bool is_piece_of(const triangle& t, face_probe& probe) const {
    return std::ranges::all_of(t, [&](const gp_Pnt& corner) {
      return probe.distance_of_surface(corner) < 100 * tolerance_;
    });
  }

  static double distance(const gp_Pnt& p, const triangle& t) {
    const auto at = [](const gp_Pnt& q) { return vec3{q.X(), q.Y(), q.Z()}; };
    return point_to_triangle(at(p), at(t[0]), at(t[1]), at(t[2]));
  }

  face_facts facts_of(face_probe& probe, const std::map<int, const face_facts*>& known) {
    face_facts facts;
    facts.area_mm2 = cad::area_of(probe.face());
    std::set<int> ids;
    for (const auto& [id, triangles] : triangles_of_)
      if (is_on(triangles, probe))
        ids.insert(id);
    if (ids.empty())
      ids = nearest_surfaces(probe);
    for (const int id : ids) {
      facts.ids.push_back(id);
      const auto row = known.find(id);
      if (row == known.end())
        continue;
      if (facts.name.empty())
        facts.name = row->second->name;
      if (!facts.looks)
        facts.looks = row->second->looks;
    }
    return facts;
  }

  /// The nearest face of a surface.
  face_probe::finding nearest(int id, const gp_Pnt& p, double at_most) {
    face_probe::finding best;
    best.distance = at_most;
    for (const auto i : probes_of_[id])
      if (const auto found = probes_[i](p, best.distance); found.distance < best.distance)
        best = found;
    return best;
  }

  /// mm: how far a point is off the surfaces of those of some faces that end beside it at most.
  template <class Faces>
  [[nodiscard]] double off_surfaces(const Faces& faces, const gp_Pnt& p) {
    const double beside = smooth_share * tolerance_;
    double off = beside;
    for (const auto i : faces)
      if (probes_[i](p, beside).distance < beside)
        off = std::min(off, probes_[i].distance_of_surface(p));
    return off;
  }

  /// mm, off its surface: of a vertex that is just beyond its face's rim, but still as near to the
  /// face's surface as the model's edges are, and on the surface of another face, which goes on
  /// there without a bend. Nothing for others.
  [[nodiscard]] std::optional<double> off_smooth_seam(int id, const gp_Pnt& p) {
    const auto& own = probes_of_[id];
    double vague = tolerance_;
    for (const auto i : own)
      vague = std::max(vague, std::min(probes_[i].vague(), seam_share * tolerance_));
    const double off = off_surfaces(own, p);
    if (off > vague)
      return std::nullopt;
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < probes_.size(); ++i)
      if (std::ranges::find(own, i) == own.end())
        others.push_back(i);
    return off_surfaces(others, p) <= tolerance_ ? std::optional(off) : std::nullopt;
  }

  void check_vertices() {
    const auto first_fresh = static_cast<std::int32_t>(mesh_.points.size() - mesh_.fresh);
    std::set<std::pair<std::int32_t, int>> seen;
    for (const auto& t : mesh_.triangles) {
      if (t[4] != triangle_made)
        continue;
      for (int k = 0; k < 3; ++k) {
        if (t[k] < first_fresh || !seen.insert({t[k], t[3]}).second)
          continue;
        const auto& at = mesh_.points[static_cast<std::size_t>(t[k])];
        const gp_Pnt p(at[0], at[1], at[2]);
        const double at_most = 0.1 * step_.size_mm;
        // Most are on a face: far ones are looked for only where none is that near.
        const double near = nearest(t[3], p, 2 * tolerance_).distance;
        double far = near <= tolerance_ ? near : nearest(t[3], p, at_most).distance;
        const auto seam = far > tolerance_ ? off_smooth_seam(t[3], p) : std::nullopt;
        far = seam.value_or(far);
        if (far > tolerance_ && !seam) {
          result_.fault = "the mesh's vertex at " + place(p) + " on surface " +
                          std::to_string(t[3]) + " is " + (far < at_most ? "" : "more than ") +
                          mm(far) + " off its faces";
          return;
        }
        result_.deviation_mm = std::max(result_.deviation_mm, far);
      }
    }
  }

  /// mm: how far corners of a triangle are off its faces, as the model's own edges may be: those
  /// that were there before, and new ones on smooth seams.
  [[nodiscard]] double off_corners(std::size_t i) {
    const auto first_fresh = static_cast<std::int32_t>(mesh_.points.size() - mesh_.fresh);
    const double near = seam_share * tolerance_;
    double off = 0;
    const int id = mesh_.triangles[i][3];
    for (std::size_t k = 0; k < 3; ++k)
      off = std::max(off, mesh_.triangles[i][k] < first_fresh
                            ? nearest(id, corners(i)[k], near).distance
                            : off_surfaces(probes_of_[id], corners(i)[k]));
    return off < near ? off : 0;
  }

  /// Of all triangles of some surfaces.
  [[nodiscard]] double off_corners(const std::vector<int>& surfaces) {
    double off = 0;
    for (const int id : surfaces)
      for (const auto i : triangles_of_.at(id))
        off = std::max(off, off_corners(i));
    return off;
  }

  void check_triangles() {
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (mesh_.triangles[i][4] != triangle_made)
        continue;
      const auto t = corners(i);
      const double edge = longest_edge(t);
      const auto found = nearest(mesh_.triangles[i][3], middle_of(t), edge + tolerance_);
      const double allowed = tolerance_ + sagitta(edge, found.curvature);
      if (found.distance > allowed && found.distance > allowed + off_corners(i)) {
        result_.fault = "a triangle of surface " + std::to_string(mesh_.triangles[i][3]) + " at " +
                        place(middle_of(t)) + " is " + mm(found.distance) + " off its faces";
        return;
      }
      chord_volume_ += area_of(t) * std::max(found.distance, sagitta(edge, found.curvature));
    }
  }

  void check_faces() {
    std::vector<std::array<vec3, 3>> boundary;
    double longest = 0;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (mesh_.triangles[i][4] == triangle_gone)
        continue;
      const auto t = corners(i);
      longest = std::max(longest, longest_edge(t));
      boundary.push_back({vec3{t[0].X(), t[0].Y(), t[0].Z()}, vec3{t[1].X(), t[1].Y(), t[1].Z()},
                          vec3{t[2].X(), t[2].Y(), t[2].Z()}});
    }
    const facet_distance to_mesh(std::move(boundary));
    for (std::size_t k = 0; k < probes_.size(); ++k) {
      if (!is_new_[k])
        continue;
      const double edge = longest_edge_of(result_.part.facts.faces[k].ids);
      for (const auto& sample :
           samples_of(probes_[k].face(), std::max(edge, 1e-3 * step_.size_mm))) {
        const double allowed = tolerance_ + sagitta(edge, sample.curvature);
        const double far = to_mesh({sample.at.X(), sample.at.Y(), sample.at.Z()}, longest);
        if (far > allowed && far > allowed + off_corners(result_.part.facts.faces[k].ids)) {
          result_.fault = "its face at " + place(sample.at) + " is " + mm(far) + " off the mesh";
          return;
        }
      }
    }
  }

  [[nodiscard]] double longest_edge_of(const std::vector<int>& ids) const {
    double longest = 0;
    for (const int id : ids)
      for (const auto i : triangles_of_.at(id))
        longest = std::max(longest, longest_edge(corners(i)));
    return longest;
  }

  void check_volume() {
    double change = 0;
    for (TopExp_Explorer all(result_.part.shape, TopAbs_FACE); all.More(); all.Next())
      if (!before_.faces.Contains(all.Current()))
        change += volume_below(TopoDS::Face(all.Current()));
    for (TopExp_Explorer all(before_.shape, TopAbs_FACE); all.More(); all.Next())
      if (!result_.part.faces.Contains(all.Current()))
        change -= volume_below(TopoDS::Face(all.Current()));
    add_chords_of_gone();
    const double allowed = 1.5 * chord_volume_ + 1e-3 * std::abs(step_.volume_change_mm3) +
                           tolerance_ * tolerance_ * step_.size_mm;
    if (std::abs(change - step_.volume_change_mm3) > allowed) {
      char text[160];
      std::snprintf(text, sizeof(text), "its volume changes by %.4g mm3, the mesh's by %.4g",
                    change, step_.volume_change_mm3);
      result_.fault = text;
    }
  }

  /// What the chords of the faces that went left out.
  void add_chords_of_gone() {
    std::map<int, std::vector<face_probe>> old;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& t = mesh_.triangles[i];
      if (t[4] != triangle_gone)
        continue;
      auto& probes = old[t[3]];
      if (probes.empty())
        for (const auto& face : before_.faces_of({t[3]}))
          probes.emplace_back(face);
      const auto c = corners(i);
      const double edge = longest_edge(c);
      face_probe::finding best;
      best.distance = edge;
      for (auto& probe : probes)
        if (const auto found = probe(middle_of(c), best.distance); found.distance < best.distance)
          best = found;
      chord_volume_ += area_of(c) * std::max(sagitta(edge, best.curvature),
                                             best.distance < edge ? best.distance : 0);
    }
  }

  const part_model& before_;
  const cad_step& step_;
  const edited_surface& mesh_;
  const double tolerance_;
  judgement result_;
  std::map<int, std::vector<std::size_t>> triangles_of_;
  std::vector<face_probe> probes_;  ///< Of each face.
  std::vector<bool> is_new_;
  std::map<int, std::vector<std::size_t>> probes_of_;
  double chord_volume_ = 0;  ///< mm3 between triangles and the faces that they stand for.
};

}  // namespace

judgement judge(const part_model& before, const TopoDS_Shape& after, const cad_step& step,
                const edited_surface& mesh) {
  return comparison(before, after, step, mesh).run();
}

}  // namespace tedit::cad
