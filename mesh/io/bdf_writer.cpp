// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <ostream>

#include "base/units.hpp"
#include "mesh/io/bdf_sets.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/io/deck_names.hpp"
#include "mesh/io/file_surfaces.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/nastran_card.hpp"

namespace tedit {

namespace {

/// The numbers of rows in a deck: their ids where all are whole numbers that it can have.
template <class Rows, class Id>
std::uint64_t bdf_number(const Rows& rows, Id id) {
  const auto fits = [](const auto& row) {
    return row.id >= 1 && static_cast<std::uint64_t>(row.id) <= largest_nastran_number;
  };
  if (std::ranges::all_of(rows, fits))
    return static_cast<std::uint64_t>(id);
  const auto place = std::ranges::find_if(rows, [&](const auto& row) { return row.id == id; });
  return static_cast<std::uint64_t>(place - rows.begin()) + 1;
}

template <class Rows>
void write_bdf_rows(std::ostream& out, const char* what, const char* word, const Rows& rows) {
  for (const auto& row : rows) {
    auto name = row.name;
    std::ranges::replace_if(
      name, [](unsigned char c) { return c < 32; }, ' ');
    out << "$ TEdit " << what << ' ' << row.id << " is " << word << bdf_number(rows, row.id) << ": "
        << name << '\n';
  }
}

void write_bdf_mesh(std::ostream& out, const mesh_version& mesh, const std::string& unit,
                    double metres) {
  const auto vertices = vertices_of_file(mesh);
  const auto tets = tets_of_file(mesh);
  out << "$ Written by TEdit: " << vertices.slots.size() << " nodes, " << tets.slots.size()
      << " tets, lengths in " << unit << '\n';
  write_bdf_names(out, mesh, unit);
  out << "BEGIN BULK\n";
  for (std::size_t i = 0; i < vertices.slots.size(); ++i) {
    const auto p = mesh.position(vertices.slots[i]) / metres;
    nastran_card(out, "GRID", true).add(std::uint64_t{i + 1}).blank().add(p.x).add(p.y).add(p.z);
  }
  for (std::size_t i = 0; i < tets.slots.size(); ++i) {
    const auto t = tets.slots[i];
    nastran_card card(out, "CTETRA");
    card.add(std::uint64_t{i + 1}).add(bdf_property(mesh, mesh.region_of(t)));
    for (const auto v : mesh.tet_at(t).v)
      card.add(std::uint64_t{vertices.index[v]} + 1);
  }
  write_bdf_surfaces(
    out, mesh, [&](tet_id t) { return std::uint64_t{tets.index[t]} + 1; },
    [&](vertex_id v) { return std::uint64_t{vertices.index[v]} + 1; });
  out << "ENDDATA\n";
}

}  // namespace

std::uint64_t bdf_property(const mesh_version& mesh, region_id region) {
  return bdf_number(mesh.regions(), region);
}

void write_bdf_names(std::ostream& out, const mesh_version& mesh, std::string_view length_unit) {
  out << "$ TEdit unit " << length_unit << '\n';
  write_bdf_rows(out, "region", "REGION-", mesh.regions());
  write_bdf_rows(out, "surface", "SURFACE-", mesh.surfaces());
}

void write_bdf_surfaces(std::ostream& out, const mesh_version& mesh,
                        const std::function<std::uint64_t(tet_id)>& element_of,
                        const std::function<std::uint64_t(vertex_id)>& node_of) {
  for (const auto& [surface, sides] : sides_of_surfaces(mesh)) {
    nastran_card card(out, "BSURFS");
    card.add(bdf_number(mesh.surfaces(), surface)).blank(3);
    for (const auto& side : sides) {
      card.add(element_of(side.tet));
      for (const auto v : corners_of(mesh, side))
        card.add(node_of(v));
    }
  }
}

expected<void> formats::bdf::write(const file_target& to, const mesh_version& mesh,
                                   const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  if (std::max(mesh.vertex_count(), mesh.tet_count()) > largest_nastran_number)
    return fail(ec::invalid_argument,
                "a deck of Nastran numbers at most 99 999 999 nodes and elements",
                "Write another format, or coarsen the mesh");
  return to.write([&](std::ostream& out) { write_bdf_mesh(out, mesh, terms.length_unit, *unit); });
}

}  // namespace tedit
