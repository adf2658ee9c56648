// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <climits>
#include <map>
#include <ostream>

#include "base/text.hpp"
#include "base/units.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/io/file_surfaces.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/group_names.hpp"
#include "mesh/io/med_content.hpp"

namespace tedit {

namespace {

/// A link of HDF5: a slash would part it.
std::string med_mesh_name(const std::string& title) {
  std::string name(cut_text(title, longest_med_name));
  std::ranges::replace_if(
    name, [](unsigned char c) { return c < 32 || c == '/'; }, '_');
  return name.empty() || name.find_first_not_of(". ") == name.npos ? "part" : name;
}

/// Makes families of surfaces and regions: an element has one of them, as it has one surface or
/// region. Those of cells have negative numbers in MED.
class med_families {
public:
  std::int32_t add(std::string_view word, std::int64_t id, std::string name) {
    std::ranges::replace(name, '\0', ' ');
    const auto number = -static_cast<std::int32_t>(all.size()) - 1;
    all.push_back(
      {number, "FAM_" + std::to_string(number), names_of_group(word, id, name, longest_med_group)});
    return number;
  }

  std::vector<med_content::family> all;
};

void put_med_nodes(med_content& out, const mesh_version& mesh, const compaction& vertices,
                   double per_metre) {
  out.coordinates.reserve(3 * vertices.slots.size());
  for (const auto v : vertices.slots) {
    const auto p = per_metre * mesh.position(v);  // The numbers that a .msh has.
    out.coordinates.insert(out.coordinates.end(), {p.x + 0.0, p.y + 0.0, p.z + 0.0});
  }
}

/// MED looks at tets and triangles from the other side than we do: the second and third corner
/// change places.
template <std::size_t N>
void put_med_corners(std::vector<std::int32_t>& out, std::array<vertex_id, N> corners,
                     const compaction& vertices) {
  std::swap(corners[1], corners[2]);
  for (const auto v : corners)
    out.push_back(static_cast<std::int32_t>(vertices.index[v]) + 1);
}

void put_med_tets(med_content& out, const mesh_version& mesh, const compaction& vertices,
                  med_families& families) {
  std::map<region_id, std::int32_t> family_of;
  for (const auto& region : mesh.regions())
    family_of[region.id] = families.add("region", region.id, region.name);
  for (const auto t : tets_of_file(mesh).slots) {
    put_med_corners(out.tets.nodes, mesh.tet_at(t).v, vertices);
    out.tets.families.push_back(family_of[mesh.region_of(t)]);
  }
}

void put_med_surfaces(med_content& out, const mesh_version& mesh, const compaction& vertices,
                      med_families& families) {
  for (const auto& [surface, sides] : sides_of_surfaces(mesh)) {
    const auto* row = mesh.find_surface(surface);
    const auto family = families.add("surface", surface, row ? row->name : "");
    for (const auto& side : sides) {
      put_med_corners(out.triangles.nodes, corners_of(mesh, side), vertices);
      out.triangles.families.push_back(family);
    }
  }
}

}  // namespace

expected<void> formats::med::write(const file_target& to, const mesh_version& mesh,
                                   const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  if (mesh.vertex_count() > INT_MAX)
    return fail(ec::invalid_argument, "a MED file has at most 2147483647 nodes", "Write .vtu");
  med_content content;
  content.name = med_mesh_name(terms.title);
  content.unit = terms.length_unit;
  const auto vertices = vertices_of_file(mesh);
  put_med_nodes(content, mesh, vertices, 1 / *unit);
  med_families families;
  put_med_surfaces(content, mesh, vertices, families);
  put_med_tets(content, mesh, vertices, families);
  content.families = std::move(families.all);
  const auto file = ask_med(to_bytes(content));
  if (!file)
    return fail(file.error());
  return to.write([&](std::ostream& out) {
    out.write(file->data(), static_cast<std::streamsize>(file->size()));
  });
}

}  // namespace tedit
