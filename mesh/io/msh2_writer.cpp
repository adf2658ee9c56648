// SPDX-License-Identifier: AGPL-3.0-or-later
#include <ostream>

#include "base/short_number.hpp"
#include "base/units.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/io/file_surfaces.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {

namespace {

/// As many as a number that reads back ever needs.
constexpr std::size_t all_digits = 24;

/// The physical group of a named surface or region: its place in the table, from 1; 0 for none.
template <class Rows, class Id>
std::size_t physical_of(const Rows& rows, Id id) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].id == id)
      return rows[i].name.empty() ? 0 : i + 1;
  return 0;
}

void write_msh2_names(std::ostream& out, const mesh_version& mesh) {
  std::string lines;
  std::size_t count = 0;
  const auto add = [&](const char* dimension, const auto& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!rows[i].name.empty()) {
        lines += dimension + std::to_string(i + 1) + " \"" + rows[i].name + "\"\n";
        ++count;
      }
  };
  add("2 ", mesh.surfaces());
  add("3 ", mesh.regions());
  if (count > 0)
    out << "$PhysicalNames\n" << count << '\n' << lines << "$EndPhysicalNames\n";
}

void write_msh2_elements(std::ostream& out, const mesh_version& mesh, const compaction& vertices) {
  const auto tets = tets_of_file(mesh);
  const auto surfaces = sides_of_surfaces(mesh);
  std::size_t count = tets.slots.size();
  for (const auto& [surface, sides] : surfaces)
    count += sides.size();
  out << "$Elements\n" << count << '\n';
  std::size_t number = 0;
  for (const auto& [surface, sides] : surfaces) {
    const auto group = physical_of(mesh.surfaces(), surface);
    for (const auto& side : sides) {
      out << ++number << " 2 2 " << group << ' ' << surface;
      for (const auto v : corners_of(mesh, side))
        out << ' ' << vertices.index[v] + 1;
      out << '\n';
    }
  }
  for (const auto t : tets.slots) {
    const auto region = mesh.region_of(t);
    out << ++number << " 4 2 " << physical_of(mesh.regions(), region) << ' ' << region;
    for (const auto v : mesh.tet_at(t).v)
      out << ' ' << vertices.index[v] + 1;
    out << '\n';
  }
  out << "$EndElements\n";
}

}  // namespace

expected<void> formats::msh2::write(const file_target& to, const mesh_version& mesh,
                                    const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  for (const auto& row : mesh.surfaces())
    if (row.id < INT32_MIN || row.id > INT32_MAX)
      return fail(ec::invalid_argument,
                  "surface id " + std::to_string(row.id) + " does not fit into a MSH file");
  const auto vertices = vertices_of_file(mesh);
  return to.write([&](std::ostream& out) {
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_msh2_names(out, mesh);
    out << "$Nodes\n" << vertices.slots.size() << '\n';
    for (std::size_t i = 0; i < vertices.slots.size(); ++i) {
      const auto p = (1 / *unit) * mesh.position(vertices.slots[i]);
      out << i + 1 << ' ' << short_number(p.x, all_digits) << ' ' << short_number(p.y, all_digits)
          << ' ' << short_number(p.z, all_digits) << '\n';
    }
    out << "$EndNodes\n";
    write_msh2_elements(out, mesh, vertices);
  });
}

expected<read_mesh> formats::msh2::read(std::span<const char> bytes) {
  return msh::read(bytes);
}

}  // namespace tedit
