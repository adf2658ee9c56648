// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/mesher/gmsh_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <set>

#include <gmsh.h>

#include "cad/mesher/gmsh_fill.hpp"
#include "cad/mesher/gmsh_nodes.hpp"

namespace tedit::cad {

namespace {

constexpr double frontal_2d = 6;
/// Of the longest edge: a strip of a face that is narrower than the first and wider than the second
/// may get edges of its own. With more such places none does: the mesh would be no coarse one.
constexpr double widest_narrow = 0.07;
constexpr double thinnest_narrow = 0.02;
constexpr std::size_t most_narrow_places = 60;

bool is_same(double a, double b) {
  return std::abs(a - b) <= 1e-3 * std::max(std::abs(a), std::abs(b)) + 1e-9;
}

}  // namespace

gmsh_part::gmsh_part(const program_call& call, const part_facts& facts, const teller& tells)
    : call_(call), facts_(facts), tells_(tells) {
  begin_gmsh();
  gmsh::option::setNumber("Geometry.OCCAutoFix", 0);
  gmsh::model::add("part");
  gmsh::vectorpair solids;
  gmsh::model::occ::importShapes((call.folder / shape_file).string(), solids);
  gmsh::model::occ::synchronize();
  check();
  for (const auto& [dimension, solid] : solids) {
    gmsh::vectorpair faces;
    gmsh::model::getBoundary({{3, solid}}, faces, false, false);
    std::set<int> once;
    for (const auto& face : faces)
      once.insert(std::abs(face.second));
    faces_of_[solid].assign(once.begin(), once.end());
  }
}

/// Ids and names go by the order of faces: it must be the reader's.
void gmsh_part::check() const {
  gmsh::vectorpair faces;
  gmsh::vectorpair solids;
  gmsh::model::getEntities(faces, 2);
  gmsh::model::getEntities(solids, 3);
  bool same = faces.size() == facts_.faces.size() && solids.size() == facts_.solids.size();
  for (std::size_t i = 0; same && i < faces.size(); ++i) {
    double area = 0;
    gmsh::model::occ::getMass(2, faces[i].second, area);
    same = faces[i].second == static_cast<int>(i + 1) && is_same(area, facts_.faces[i].area_mm2);
  }
  for (std::size_t i = 0; same && i < solids.size(); ++i) {
    double volume = 0;
    gmsh::model::occ::getMass(3, solids[i].second, volume);
    same =
      solids[i].second == static_cast<int>(i + 1) && is_same(volume, facts_.solids[i].volume_mm3);
  }
  if (!same)
    tells_.refuse({ec::internal,
                   "Gmsh numbers the " + std::to_string(faces.size()) + " faces and " +
                     std::to_string(solids.size()) + " solids otherwise than they were read",
                   "This is a defect of TEdit: please report it with the CAD file",
                   {}});
}

/// Each corner gets the size of the thinnest solid that it is on.
void gmsh_part::set_sizes(const fineness& size) {
  std::map<int, double> at_corner;
  wall_mm_ = HUGE_VAL;
  for (const auto& [solid, faces] : faces_of_) {
    const auto& facts = facts_.solids[static_cast<std::size_t>(solid) - 1];
    const double wall = 2 * facts.volume_mm3 / facts.area_mm2;
    const double h = size.wall_share * wall;
    size_mm_ = std::max(size_mm_, h);
    wall_mm_ = std::min(wall_mm_, wall);
    gmsh::vectorpair points;
    gmsh::model::getBoundary({{3, solid}}, points, false, false, true);
    for (const auto& [dimension, point] : points) {
      const auto [at, is_new] = at_corner.emplace(point, h);
      at->second = std::min(at->second, h);
    }
  }
  for (const auto& [point, h] : at_corner)
    gmsh::model::mesh::setSize({{0, point}}, h);
  const auto set = [](const char* option, double value) { gmsh::option::setNumber(option, value); };
  set("Mesh.MeshSizeMax", size_mm_);
  least_mm_ = least_share * size.wall_share * wall_mm_;
  set("Mesh.MeshSizeMin", least_mm_);
  set("Mesh.MeshSizeFromCurvature", size.on_circle);
  set("Mesh.MeshSizeExtendFromBoundary", 1);
  set("Mesh.Algorithm", frontal_2d);
}

/// Gmsh takes the least of all sizes that are given at a place.
void gmsh_part::set_local_sizes(const std::map<int, double>& local) {
  std::map<int, double> of_curves;
  for (const auto& [face, mm] : local) {
    least_local_mm_ = std::min(least_local_mm_, mm);
    gmsh::vectorpair curves;
    gmsh::model::getBoundary({{2, face}}, curves, false, false);
    for (const auto& [dimension, curve] : curves)
      if (const auto [row, fresh] = of_curves.emplace(std::abs(curve), mm); !fresh)
        row->second = std::min(row->second, mm);
  }
  if (local.empty() && narrow_.all.empty())
    return;
  gmsh::option::setNumber("Mesh.MeshSizeMin", std::min(least_mm_, least_local_mm_));
  gmsh::model::mesh::setSizeCallback(
    [of_curves, local, this](int dimension, int tag, double x, double y, double z) {
      const auto& sizes = dimension == 1 ? of_curves : local;
      const auto found = dimension == 1 || dimension == 2 ? sizes.find(tag) : sizes.end();
      return std::min(found == sizes.end() ? size_mm_ : found->second, narrow_.size_at({x, y, z}));
    });
}

/// Meshes curves and faces at narrow places anew, and before the others: there alone edges may be
/// shorter than anywhere else.
void gmsh_part::mesh_narrow_faces() {
  const auto set = [](const char* option, double value) { gmsh::option::setNumber(option, value); };
  set("Mesh.MeshSizeMin", std::min({least_mm_, least_local_mm_, narrow_.all.front().size}));
  set("Mesh.MeshOnlyEmpty", 1);
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  gmsh::model::mesh::clear(faces);
  gmsh::vectorpair curves;
  for (const int curve : narrow_.curves)
    curves.emplace_back(1, curve);
  gmsh::model::mesh::clear(curves);
  gmsh::model::mesh::generate(1);
  gmsh::vectorpair others;
  std::ranges::copy_if(faces, std::back_inserter(others),
                       [&](const auto& face) { return !narrow_.faces.contains(face.second); });
  set("Mesh.MeshOnlyVisible", 1);
  gmsh::model::setVisibility(others, 0);
  gmsh::model::mesh::generate(2);
  gmsh::model::setVisibility(others, 1);
  set("Mesh.MeshOnlyVisible", 0);
  set("Mesh.MeshSizeMin", std::min(least_mm_, least_local_mm_));
}

std::string gmsh_part::surface_words(int tag) const {
  const auto& name = facts_.faces[static_cast<std::size_t>(tag) - 1].name;
  return "surface " + std::to_string(tag) + (name.empty() ? "" : " (" + name + ")");
}

surface_mesh gmsh_part::mesh_faces(const fineness& size, const std::map<int, double>& local) {
  set_sizes(size);
  set_local_sizes(local);
  tells_.stage(0.15, "meshing the curves");
  gmsh::model::mesh::generate(1);
  tells_.stage(0.2, "meshing the surfaces");
  gmsh::model::mesh::generate(2);
  return meshed_faces();
}

std::optional<surface_mesh> gmsh_part::mesh_faces_finer_where_narrow(
  const std::map<int, double>& local) {
  narrow_ =
    find_narrow_places(widest_narrow * size_mm_, thinnest_narrow * size_mm_, most_narrow_places);
  if (narrow_.all.empty())
    return std::nullopt;
  tells_.stage(0.3, "meshing narrow strips of surfaces anew");
  set_local_sizes(local);
  mesh_narrow_faces();
  gmsh::model::mesh::generate(2);
  return meshed_faces();
}

void gmsh_part::forget_narrow_places() {
  narrow_ = {};
  gmsh::option::setNumber("Mesh.MeshOnlyEmpty", 0);
}

surface_mesh gmsh_part::meshed_faces() const {
  const nodes_of_mesh nodes;
  surface_mesh mesh;
  for (std::size_t i = 0; i < nodes.at.size(); i += 3)
    mesh.points.push_back({nodes.at[i], nodes.at[i + 1], nodes.at[i + 2]});
  for (int face = 1; face <= static_cast<int>(facts_.faces.size()); ++face) {
    const auto triangles = nodes.of_elements<3>(gmsh_triangle, face);
    if (triangles.empty())
      tells_.refuse({ec::mesher_failed,
                     "Gmsh made no triangles on " + surface_words(face),
                     "Mesh it coarser or finer, or mend that face in the CAD program",
                     {}});
    for (const auto& [a, b, c] : triangles)
      mesh.triangles.push_back({{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                 static_cast<std::uint32_t>(c)},
                                face});
  }
  return mesh;
}

bool gmsh_part::fill(const surface_mesh& faces) {
  return fill_solids(faces, faces_of_, call_.folder);
}

}  // namespace tedit::cad
