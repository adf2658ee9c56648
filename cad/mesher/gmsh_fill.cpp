// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/mesher/gmsh_fill.hpp"

#include <fstream>
#include <new>
#include <set>

#include "cad/exchange.hpp"
#include "cad/mesher/gmsh_nodes.hpp"

namespace tedit::cad {

namespace {

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
    gmsh::model::mesh::addElementsByType(surface, gmsh_triangle, {}, nodes);
}

template <class T>
void put(std::ofstream& out, const T* first, std::size_t count) {
  out.write(reinterpret_cast<const char*>(first), static_cast<std::streamsize>(count * sizeof(T)));
}

/// Writes the mesh as it is; false where a solid has no tets, or a face lost triangles.
bool write_filled(const surface_mesh& faces, const std::map<int, std::vector<int>>& faces_of,
                  const std::filesystem::path& folder) {
  const nodes_of_mesh nodes;  // Gmsh has numbered them anew.
  std::vector<std::array<std::int32_t, 4>> triangles;
  std::set<int> surfaces;  // Gmsh does not know those that went.
  for (const auto& one : faces.triangles)
    surfaces.insert(one.surface);
  for (const auto surface : surfaces)
    for (const auto& [a, b, c] : nodes.of_elements<3>(gmsh_triangle, surface))
      triangles.push_back({a, b, c, surface});
  std::vector<std::array<std::int32_t, 5>> tets;
  for (const auto& [solid, around] : faces_of) {
    const auto filled = nodes.of_elements<4>(gmsh_tet, solid);
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
  std::ofstream out(folder / mesh_file, std::ios::binary);
  put(out, &header, 1);
  put(out, nodes.at.data(), nodes.at.size());
  put(out, triangles.data(), triangles.size());
  put(out, tets.data(), tets.size());
  return static_cast<bool>(out.flush());
}

}  // namespace

bool fill_solids(const surface_mesh& faces, const std::map<int, std::vector<int>>& faces_of,
                 const std::filesystem::path& folder) {
  gmsh::model::add("filled");
  std::map<int, std::vector<std::size_t>> nodes_of;
  for (const auto& one : faces.triangles)
    for (const auto v : one.v)
      nodes_of[one.surface].push_back(v + std::size_t{1});
  add_surfaces(faces, nodes_of);
  for (const auto& [solid, around] : faces_of) {
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
    done = write_filled(faces, faces_of, folder);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    done = false;  // It says why in its messages.
  }
  gmsh::model::remove();
  return done;
}

}  // namespace tedit::cad
