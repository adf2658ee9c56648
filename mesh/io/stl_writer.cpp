// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/stl_writer.hpp"

#include <ostream>

#include "base/units.hpp"
#include "mesh/io/file.hpp"

namespace tedit {

namespace {

void put_float3(std::ostream& out, vec3 value) {
  const std::array<float, 3> f{static_cast<float>(value.x), static_cast<float>(value.y),
                               static_cast<float>(value.z)};
  out.write(reinterpret_cast<const char*>(f.data()), sizeof(f));
}

}  // namespace

expected<void> write_stl(const file_target& to, const mesh_version& mesh,
                         const std::string& length_unit) {
  const auto unit = metres_per_unit(length_unit);
  if (!unit)
    return fail(unit.error());
  return to.write([&](std::ostream& out) {
    std::string header = "TEdit boundary, unit " + length_unit;
    header.resize(80, ' ');
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

}  // namespace tedit
