// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/field_writer.hpp"

#include "mesh/io/vtu_writer.hpp"

namespace tedit {

namespace {

/// The slots in use, and for each slot its place among them.
struct numbering {
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> index;
};

template <class IsLive>
numbering number(std::uint32_t slots, const IsLive& is_live) {
  numbering result;
  result.index.assign(slots, no_id);
  for (std::uint32_t s = 0; s < slots; ++s)
    if (is_live(s)) {
      result.index[s] = static_cast<std::uint32_t>(result.slots.size());
      result.slots.push_back(s);
    }
  return result;
}

std::vector<double> compact(const field& f, const std::vector<std::uint32_t>& slots) {
  std::vector<double> values;
  values.reserve(slots.size() * static_cast<std::size_t>(f.components));
  for (const auto slot : slots)
    for (int c = 0; c < f.components; ++c)
      values.push_back(f.at(slot, c));
  return values;
}

}  // namespace

expected<void> write_vtu(const file_target& to, const mesh_version& mesh,
                         const std::vector<field>& fields,
                         const std::vector<std::pair<std::string, std::string>>& notes) {
  const auto vertices =
    number(mesh.vertex_slots(), [&](vertex_id v) { return mesh.is_live_vertex(v); });
  const auto tets = number(mesh.tet_slots(), [&](tet_id t) { return mesh.is_live_tet(t); });
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
  grid.notes = notes;
  grid.cell_data.push_back({"region", 1, regions});
  std::vector<std::vector<double>> values;
  values.reserve(fields.size());
  for (const auto& f : fields) {
    const bool on_vertices = f.location == field_location::vertex;
    values.push_back(compact(f, on_vertices ? vertices.slots : tets.slots));
    (on_vertices ? grid.point_data : grid.cell_data)
      .push_back({f.name, f.components, values.back()});
  }
  return write_vtu(to, grid);
}

}  // namespace tedit
