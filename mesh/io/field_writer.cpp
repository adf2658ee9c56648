// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "mesh/io/compaction.hpp"
#include "mesh/io/file_surfaces.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/vtu_writer.hpp"

namespace tedit {

namespace {

std::vector<double> pick(const field& f, const std::vector<std::uint32_t>& slots) {
  std::vector<double> values;
  values.reserve(slots.size() * static_cast<std::size_t>(f.components));
  for (const auto slot : slots)
    for (int c = 0; c < f.components; ++c)
      values.push_back(f.at(slot, c));
  return values;
}

/// Surfaces beside the cells, which stay tets alone for who looks at fields: triangles, ids, names.
struct surface_tables {
  std::vector<std::int64_t> triangles;
  std::vector<std::int64_t> of_triangle;
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> regions;

  surface_tables(const mesh_version& mesh, const compaction& vertices, vtu_grid& grid) {
    for (const auto& [surface, sides] : sides_of_surfaces(mesh))
      for (const auto& side : sides) {
        for (const auto v : corners_of(mesh, side))
          triangles.push_back(vertices.index[v]);
        of_triangle.push_back(surface);
      }
    std::vector<std::string> names;
    for (const auto& row : mesh.surfaces()) {
      ids.push_back(row.id);
      names.push_back(row.name);
    }
    grid.texts.emplace_back("surface_names", std::move(names));
    names.clear();
    for (const auto& row : mesh.regions()) {
      regions.push_back(row.id);
      names.push_back(row.name);
    }
    grid.texts.emplace_back("region_names", std::move(names));
    grid.texts.emplace_back("length_unit", std::vector<std::string>{"m"});
    grid.numbers = {{"surface_triangles", 3, triangles},
                    {"surface_of_triangle", 1, of_triangle},
                    {"surface_ids", 1, ids},
                    {"region_ids", 1, regions}};
  }
};

}  // namespace

namespace formats {

bool vtu::recognises(std::span<const char> bytes) {
  const std::string_view text(bytes.data(), std::min<std::size_t>(bytes.size(), 1000));
  return text.starts_with("<") && text.find("<VTKFile") != text.npos;
}

expected<void> vtu::write(const file_target& to, const mesh_version& mesh,
                          const file_terms& terms) {
  const auto vertices = vertices_of_file(mesh);
  const auto tets = tets_of_file(mesh);
  std::vector<vec3> points;
  points.reserve(vertices.slots.size());
  for (const auto v : vertices.slots)
    points.push_back(mesh.position(v));
  std::vector<std::uint32_t> cells;
  std::vector<double> regions;
  cells.reserve(4 * tets.slots.size());
  for (const auto t : tets.slots) {
    for (const auto v : mesh.tet_at(t).v)
      cells.push_back(vertices.index[v]);
    regions.push_back(mesh.region_of(t));
  }
  vtu_grid grid;
  grid.points = points;
  grid.cells = cells;
  grid.notes = terms.notes;
  const surface_tables surfaces(mesh, vertices, grid);
  grid.cell_data.push_back({"region", 1, regions});
  std::vector<std::vector<double>> values;
  values.reserve(terms.fields.size());
  for (const auto& f : terms.fields) {
    const bool on_vertices = f.location == field_location::vertex;
    values.push_back(pick(f, on_vertices ? vertices.slots : tets.slots));
    (on_vertices ? grid.point_data : grid.cell_data)
      .push_back({f.name, f.components, values.back()});
  }
  return write_vtu(to, grid);
}

}  // namespace formats

}  // namespace tedit
