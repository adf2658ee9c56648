// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "mesh/io/compaction.hpp"
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
