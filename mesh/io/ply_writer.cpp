// SPDX-License-Identifier: AGPL-3.0-or-later
#include <ostream>

#include "base/units.hpp"
#include "mesh/io/file_boundary.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {

namespace {

template <class Items>
void put_bytes(std::ostream& out, const Items& items) {
  out.write(reinterpret_cast<const char*>(items.data()),
            static_cast<std::streamsize>(items.size() * sizeof(items[0])));
}

void put_ply_header(std::ostream& out, const std::string& unit, std::size_t vertices,
                    std::size_t facets, const file_colours& colours) {
  const char* rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  out << "ply\nformat binary_little_endian 1.0\ncomment TEdit boundary, unit " << unit
      << "\nelement vertex " << vertices
      << "\nproperty float x\nproperty float y\nproperty float z\n"
      << (colours.of_vertices.empty() ? "" : rgb) << "element face " << facets
      << "\nproperty list uchar int vertex_indices\n"
      << (colours.of_surfaces.empty() && colours.of_facets.empty() ? "" : rgb) << "end_header\n";
}

}  // namespace

namespace formats {

bool ply::recognises(std::span<const char> bytes) {
  const std::string_view text(bytes.data(), bytes.size());
  return text.starts_with("ply\n") || text.starts_with("ply\r");
}

expected<void> ply::write(const file_target& to, const mesh_version& mesh,
                          const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  const auto& colours = terms.colours;
  const auto vertices = boundary_vertices_of_file(mesh);
  return to.write([&](std::ostream& out) {
    put_ply_header(out, terms.length_unit, vertices.slots.size(), mesh.facet_count(), colours);
    for (const auto v : vertices.slots) {
      const auto p = mesh.position(v) / *unit;
      put_bytes(
        out, std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      if (!colours.of_vertices.empty())
        put_bytes(out, colours.palette[colours.of_vertices[v]]);
    }
    for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
      if (!mesh.is_live_facet(f))
        continue;
      const auto& v = mesh.facet(f).v;
      out.put(3);
      put_bytes(out, std::array{vertices.index[v[0]], vertices.index[v[1]], vertices.index[v[2]]});
      if (!colours.of_facets.empty())
        put_bytes(out, colours.palette[colours.of_facets[f]]);
      else if (!colours.of_surfaces.empty())
        put_bytes(out, colour_of_surface(colours, mesh.facet(f).surface));
    }
  });
}

}  // namespace formats

}  // namespace tedit
