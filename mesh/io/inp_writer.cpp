// SPDX-License-Identifier: AGPL-3.0-or-later
#include <ostream>

#include "base/short_number.hpp"
#include "base/units.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/io/deck_names.hpp"
#include "mesh/io/file_surfaces.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/inp_sets.hpp"

namespace tedit {

namespace {

/// CalculiX reads 20 characters of a number.
constexpr std::size_t longest_inp_number = 20;

/// The name that Abaqus has for the face opposite to a corner.
constexpr std::array<const char*, 4> side_names{"S3", "S4", "S2", "S1"};

std::map<region_id, std::vector<tet_id>> tets_by_region(const mesh_version& mesh,
                                                        const compaction& tets) {
  std::map<region_id, std::vector<tet_id>> result;
  for (const auto t : tets.slots)
    result[mesh.region_of(t)].push_back(t);
  return result;
}

void write_inp_mesh(std::ostream& out, const mesh_version& mesh, const std::string& unit,
                    double metres) {
  const auto vertices = vertices_of_file(mesh);
  const auto tets = tets_of_file(mesh);
  out << "** Written by TEdit: " << vertices.slots.size() << " nodes, " << tets.slots.size()
      << " tets, lengths in " << unit << '\n';
  write_name_comments(out, "** ", mesh, unit);
  out << "*NODE, NSET=NALL\n";
  for (std::size_t i = 0; i < vertices.slots.size(); ++i) {
    const auto p = mesh.position(vertices.slots[i]) / metres;
    out << i + 1 << ", " << short_number(p.x, longest_inp_number) << ", "
        << short_number(p.y, longest_inp_number) << ", " << short_number(p.z, longest_inp_number)
        << '\n';
  }
  for (const auto& [region, list] : tets_by_region(mesh, tets)) {
    out << "*ELEMENT, TYPE=C3D4, ELSET=" << region_word(region) << '\n';
    for (const auto t : list) {
      out << tets.index[t] + 1;
      for (const auto v : mesh.tet_at(t).v)
        out << ", " << vertices.index[v] + 1;
      out << '\n';
    }
  }
  write_inp_surfaces(out, mesh, [&](tet_id t) { return tets.index[t] + 1; });
}

}  // namespace

void write_inp_surfaces(std::ostream& out, const mesh_version& mesh,
                        const std::function<std::size_t(tet_id)>& element_of) {
  for (const auto& [surface, sides] : sides_of_surfaces(mesh)) {
    out << "*SURFACE, NAME=" << surface_word(surface) << ", TYPE=ELEMENT\n";
    for (const auto& side : sides)
      out << element_of(side.tet) << ", " << side_names[static_cast<std::size_t>(side.face)]
          << '\n';
  }
}

void write_inp_sets(std::ostream& out, const mesh_version& mesh,
                    const std::function<std::size_t(tet_id)>& element_of) {
  write_name_comments(out, "** ", mesh, "m");
  for (const auto& [region, list] : tets_by_region(mesh, tets_of_file(mesh))) {
    out << "*ELSET, ELSET=" << region_word(region) << '\n';
    for (const auto t : list)
      out << element_of(t) << ",\n";
  }
  write_inp_surfaces(out, mesh, element_of);
}

expected<void> formats::inp::write(const file_target& to, const mesh_version& mesh,
                                   const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  return to.write([&](std::ostream& out) { write_inp_mesh(out, mesh, terms.length_unit, *unit); });
}

}  // namespace tedit
