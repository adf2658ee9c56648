// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <ostream>

#include "base/units.hpp"
#include "mesh/io/file_boundary.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {

namespace {

/// In the names of groups blanks part words, and '#' begins a comment.
std::string group_of(const mesh_version& mesh, surface_id surface) {
  const auto* row = mesh.find_surface(surface);
  std::string result = row && !row->name.empty() ? row->name + "_" : std::string("surface_");
  std::ranges::replace_if(
    result, [](unsigned char c) { return c <= ' ' || c == '#' || c == '\\' || c == 127; }, '_');
  return result + std::to_string(surface);
}

/// The first word of a line that is neither empty nor a comment.
std::string_view first_word(std::string_view text) {
  while (!text.empty()) {
    const auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const auto from = line.find_first_not_of(" \t\r");
    if (from == line.npos || line[from] == '#')
      continue;
    return line.substr(from, line.find_first_of(" \t\r", from) - from);
  }
  return {};
}

}  // namespace

namespace formats {

bool obj::recognises(std::span<const char> bytes) {
  constexpr std::string_view keywords[] = {"v", "vn", "vt", "o", "g", "mtllib", "usemtl", "s"};
  constexpr std::size_t enough = 4096;
  const std::string_view text(bytes.data(), std::min(bytes.size(), enough));
  return std::ranges::find(keywords, first_word(text)) != std::end(keywords);
}

expected<void> obj::write(const file_target& to, const mesh_version& mesh,
                          const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  std::map<surface_id, std::vector<facet_id>> groups;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    groups[mesh.facet(f).surface].push_back(f);
  }
  const auto vertices = boundary_vertices_of_file(mesh);
  return to.write([&](std::ostream& out) {
    out.precision(15);  // Of what an edit or a file gave; more digits would be those of its unit.
    out << "# TEdit boundary, unit " << terms.length_unit << '\n';
    for (const auto v : vertices.slots) {
      const auto p = mesh.position(v) / *unit;
      out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    for (const auto& [surface, facets] : groups) {
      out << "g " << group_of(mesh, surface) << '\n';
      for (const auto f : facets) {
        out << 'f';
        for (const auto v : mesh.facet(f).v)
          out << ' ' << vertices.index[v] + 1;
        out << '\n';
      }
    }
  });
}

}  // namespace formats

}  // namespace tedit
