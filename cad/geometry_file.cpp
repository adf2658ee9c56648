// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/geometry_file.hpp"

#include <fstream>
#include <iterator>

#include "cad/exchange.hpp"
#include "mesh/geometry_bytes.hpp"

namespace tedit::cad {

bool save_geometries(const std::vector<surface_geometry>& faces,
                     const std::filesystem::path& folder) {
  byte_writer bytes;
  for (const auto& one : faces)
    write_geometry(one, bytes);
  std::ofstream out(folder / geometry_file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.bytes.data()),
            static_cast<std::streamsize>(bytes.bytes.size()));
  return static_cast<bool>(out.flush());
}

expected<std::vector<surface_geometry>> load_geometries(const std::filesystem::path& folder) {
  std::ifstream from(folder / geometry_file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(from), std::istreambuf_iterator<char>()};
  byte_reader in(std::as_bytes(std::span(text)));
  std::vector<surface_geometry> faces;
  while (!in.at_end()) {
    auto one = read_geometry(in);
    if (!one)
      return fail(ec::internal, "what the reader wrote of the faces' geometry is damaged",
                  "Try again; if it stays, report it with the CAD file");
    faces.push_back(std::move(*one));
  }
  return faces;
}

}  // namespace tedit::cad
