// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstring>
#include <ostream>

#include "base/units.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {

namespace {

// A binary file: text, the number of triangles, the triangles.
constexpr std::size_t stl_header_bytes = 80;
constexpr std::size_t triangle_bytes = 50;

void put_float3(std::ostream& out, vec3 value) {
  const std::array<float, 3> f{static_cast<float>(value.x), static_cast<float>(value.y),
                               static_cast<float>(value.z)};
  out.write(reinterpret_cast<const char*>(f.data()), sizeof(f));
}

}  // namespace

namespace formats {

bool stl::recognises(std::span<const char> bytes) {
  if (std::string_view(bytes.data(), bytes.size()).starts_with("solid "))
    return true;
  std::uint32_t count = 0;
  if (bytes.size() < stl_header_bytes + sizeof(count))
    return false;
  std::memcpy(&count, bytes.data() + stl_header_bytes, sizeof(count));
  return bytes.size() == stl_header_bytes + sizeof(count) + std::size_t{count} * triangle_bytes;
}

expected<void> stl::write(const file_target& to, const mesh_version& mesh,
                          const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  return to.write([&](std::ostream& out) {
    std::string header = "TEdit boundary, unit " + terms.length_unit;
    header.resize(stl_header_bytes, ' ');
    out << header;
    const std::uint32_t count = mesh.facet_count();
    out.write(reinterpret_cast<const char*>(&count), sizeof(count));
    for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
      if (!mesh.is_live_facet(f))
        continue;
      put_float3(out, normalized(area_vector(mesh, mesh.facet(f))));
      for (const auto v : mesh.facet(f).v)
        put_float3(out, mesh.position(v) / *unit);
      const std::uint16_t attribute = 0;
      out.write(reinterpret_cast<const char*>(&attribute), sizeof(attribute));
    }
  });
}

}  // namespace formats

}  // namespace tedit
