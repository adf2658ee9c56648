// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/mesher/gmsh_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <new>
#include <set>

#include <gmsh.h>

namespace tedit::cad {

namespace {

constexpr int triangle_type = 2;
constexpr int tet_type = 4;
constexpr double frontal_2d = 6;
constexpr double hxt_3d = 10;

/// Round faces are met with edges down to this share of the smallest solid's size: small fillets of
/// a large part have fewer edges on a circle.
constexpr double least_share = 0.25;

bool is_same(double a, double b) {
  return std::abs(a - b) <= 1e-3 * std::max(std::abs(a), std::abs(b)) + 1e-9;
}

/// The nodes of the current model, by their places.
class nodes_of_mesh {
public:
  nodes_of_mesh() {
    std::vector<std::size_t> tags;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(tags, at, parameters, -1, -1, false, false);
    for (std::size_t i = 0; i < tags.size(); ++i)
      index_[tags[i]] = static_cast<std::int32_t>(i);
  }

  /// The corners of each element of this type on an entity.
  template <std::size_t Corners>
  [[nodiscard]] std::vector<std::array<std::int32_t, Corners>> of_elements(int type,
                                                                           int entity) const {
    std::vector<std::size_t> elements;
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
    std::vector<std::array<std::int32_t, Corners>> result(elements.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      result[i / Corners][i % Corners] = index_.at(nodes[i]);
    return result;
  }

  std::vector<double> at;  ///< Three for each node.

private:
  std::map<std::size_t, std::int32_t> index_;
};

/// The triangles as a model of their own.
void add_surfaces(const surface_mesh& faces,
                  const std::map<int, std::vector<std::size_t>>& nodes_of) {
  for (const auto& [surface, nodes] : nodes_of)
    gmsh::model::addDiscreteEntity(2, surface);
  std::vector<bool> is_there(faces.points.size(), false);
  for (const auto& [surface, nodes] : nodes_of) {
    std::vector<std::size_t> tags;
    std::vector<double> at;
    for (const auto tag : nodes) {
      if (is_there[tag - 1])
        continue;
      is_there[tag - 1] = true;
      const auto& p = faces.points[tag - 1];
      tags.push_back(tag);
      at.insert(at.end(), {p.x, p.y, p.z});
    }
    gmsh::model::mesh::addNodes(2, surface, tags, at);
  }
  for (const auto& [surface, nodes] : nodes_of)
    gmsh::model::mesh::addElementsByType(surface, triangle_type, {}, nodes);
}

template <class T>
void put(std::ofstream& out, const T* first, std::size_t count) {
  out.write(reinterpret_cast<const char*>(first), static_cast<std::streamsize>(count * sizeof(T)));
}

}  // namespace

fineness fineness_of(const std::string& name) {
  return name == "fine" ? fineness{1.0 / 3, 12} : name == "medium" ? fineness{0.5, 8} : fineness{};
}

gmsh_part::gmsh_part(const program_call& call, const part_facts& facts, const teller& tells)
    : call_(call), facts_(facts), tells_(tells) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 1);    // Into the folder's file.
  gmsh::option::setNumber("General.NumThreads", 1);  // The same mesh each time.
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
  set("Mesh.MeshSizeMin", least_share * size.wall_share * wall_mm_);
  set("Mesh.MeshSizeFromCurvature", size.on_circle);
  set("Mesh.MeshSizeExtendFromBoundary", 1);
  set("Mesh.Algorithm", frontal_2d);
  set("Mesh.Algorithm3D", hxt_3d);
}

std::string gmsh_part::surface_words(int tag) const {
  const auto& name = facts_.faces[static_cast<std::size_t>(tag) - 1].name;
  return "surface " + std::to_string(tag) + (name.empty() ? "" : " (" + name + ")");
}

surface_mesh gmsh_part::mesh_faces(const fineness& size) {
  set_sizes(size);
  tells_.stage(0.15, "meshing the curves");
  gmsh::model::mesh::generate(1);
  tells_.stage(0.2, "meshing the surfaces");
  gmsh::model::mesh::generate(2);
  const nodes_of_mesh nodes;
  surface_mesh mesh;
  for (std::size_t i = 0; i < nodes.at.size(); i += 3)
    mesh.points.push_back({nodes.at[i], nodes.at[i + 1], nodes.at[i + 2]});
  for (int face = 1; face <= static_cast<int>(facts_.faces.size()); ++face) {
    const auto triangles = nodes.of_elements<3>(triangle_type, face);
    if (triangles.empty())
      tells_.refuse({ec::mesher_failed,
                     "Gmsh made no triangles on " + surface_words(face),
                     "Try another --size, or mend that face in the CAD program",
                     {}});
    for (const auto& [a, b, c] : triangles)
      mesh.triangles.push_back({{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                 static_cast<std::uint32_t>(c)},
                                face});
  }
  return mesh;
}

bool gmsh_part::fill(const surface_mesh& faces) {
  gmsh::model::add("filled");
  std::map<int, std::vector<std::size_t>> nodes_of;
  for (const auto& one : faces.triangles)
    for (const auto v : one.v)
      nodes_of[one.surface].push_back(v + std::size_t{1});
  add_surfaces(faces, nodes_of);
  for (const auto& [solid, around] : faces_of_) {
    std::vector<int> left;
    for (const auto face : around)
      if (nodes_of.contains(face))
        left.push_back(face);
    gmsh::model::geo::addSurfaceLoop(left, solid);
    gmsh::model::geo::addVolume({solid}, solid);
  }
  gmsh::model::geo::synchronize();
  bool done = false;
  try {
    gmsh::model::mesh::generate(3);
    done = write(faces);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    done = false;  // It says why in its messages.
  }
  gmsh::model::remove();
  return done;
}

bool gmsh_part::write(const surface_mesh& faces) const {
  const nodes_of_mesh nodes;  // Gmsh has numbered them anew.
  std::vector<std::array<std::int32_t, 4>> triangles;
  std::set<int> surfaces;  // Gmsh does not know those that went.
  for (const auto& one : faces.triangles)
    surfaces.insert(one.surface);
  for (const auto surface : surfaces)
    for (const auto& [a, b, c] : nodes.of_elements<3>(triangle_type, surface))
      triangles.push_back({a, b, c, surface});
  std::vector<std::array<std::int32_t, 5>> tets;
  for (const auto& [solid, around] : faces_of_) {
    const auto filled = nodes.of_elements<4>(tet_type, solid);
    if (filled.empty())
      return false;
    for (const auto& [a, b, c, d] : filled)
      tets.push_back({a, b, c, d, solid});
  }
  if (triangles.size() != faces.triangles.size())
    return false;
  mesh_header header;
  header.points = nodes.at.size() / 3;
  header.triangles = triangles.size();
  header.tets = tets.size();
  std::ofstream out(call_.folder / mesh_file, std::ios::binary);
  put(out, &header, 1);
  put(out, nodes.at.data(), nodes.at.size());
  put(out, triangles.data(), triangles.size());
  put(out, tets.data(), tets.size());
  return static_cast<bool>(out.flush());
}

}  // namespace tedit::cad
