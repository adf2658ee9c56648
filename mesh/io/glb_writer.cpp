// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <ostream>

#include <nlohmann/json.hpp>

#include "mesh/io/file_boundary.hpp"
#include "mesh/io/formats.hpp"

// glTF 2.0, sections 3 (the JSON) and 4 (the binary file).
namespace tedit {

namespace {

using json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little);

constexpr std::uint32_t version_of_gltf = 2;
constexpr std::string_view json_chunk = "JSON";
constexpr std::string_view binary_chunk{"BIN\0", 4};
constexpr std::size_t header_bytes = 12;
constexpr std::size_t chunk_header_bytes = 8;
// OpenGL's numbers, as glTF has them.
constexpr int type_uint = 5125, type_ushort = 5123, type_float = 5126;
constexpr int target_vertices = 34962, target_indices = 34963;

constexpr byte_colour white{255, 255, 255};

/// glTF has light, not what screens are given (IEC 61966-2-1).
double light_of(std::uint8_t value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Facets that look alike: a primitive with its material.
struct patch {
  std::string name;
  std::optional<surface_id> surface;  ///< None of facets that a field gave their colour.
  byte_colour colour{};
  std::vector<std::uint32_t> corners;
};

patch patch_of_surface(const mesh_version& mesh, const file_colours& colours, surface_id surface) {
  patch result;
  const auto* row = mesh.find_surface(surface);
  result.name =
    row && !row->name.empty() ? row->name : std::string("surface ") + std::to_string(surface);
  result.surface = surface;
  // White is multiplied with the colours of the vertices.
  result.colour = colours.of_vertices.empty() ? colour_of_surface(colours, surface) : white;
  return result;
}

std::vector<patch> patches_of(const mesh_version& mesh, const file_colours& colours,
                              const compaction& vertices) {
  std::map<std::int64_t, patch> found;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& facet = mesh.facet(f);
    const bool by_facet = !colours.of_facets.empty();
    const auto key =
      by_facet ? static_cast<std::int64_t>(colours.of_facets[f]) : std::int64_t{facet.surface};
    const auto [row, fresh] = found.try_emplace(key);
    if (fresh && by_facet)
      row->second.colour = colours.palette[colours.of_facets[f]];
    else if (fresh)
      row->second = patch_of_surface(mesh, colours, facet.surface);
    for (const auto v : facet.v)
      row->second.corners.push_back(vertices.index[v]);
  }
  std::vector<patch> result;
  for (auto& [key, one] : found)
    result.push_back(std::move(one));
  return result;
}

json material_of(const patch& one) {
  json result;
  if (!one.name.empty())
    result["name"] = one.name;
  const auto& c = one.colour;
  result["pbrMetallicRoughness"] = {
    {"baseColorFactor", {light_of(c[0]), light_of(c[1]), light_of(c[2]), 1.0}},
    {"metallicFactor", 0.0},
    {"roughnessFactor", 0.7}};
  if (one.surface)
    result["extras"] = {{"surface", *one.surface}};
  return result;
}

/// The JSON, and how many bytes follow it.
class document {
public:
  explicit document(const std::string& title) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "TEdit"}};
    json_["scene"] = 0;
    json_["scenes"] = json::array({{{"nodes", json::array({0})}}});
    // There y is up; in CAD z is.
    json node{{"mesh", 0}, {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}}};
    json mesh{{"primitives", json::array()}};
    if (!title.empty())
      node["name"] = mesh["name"] = title;
    json_["nodes"] = json::array({node});
    json_["meshes"] = json::array({mesh});
  }

  /// Returns the number of the accessor.
  std::size_t add_array(std::size_t count, int type, const char* shape, std::size_t item_bytes,
                        int target) {
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", bytes_},
                                    {"byteLength", count * item_bytes},
                                    {"target", target}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", type},
                                  {"count", count},
                                  {"type", shape}});
    bytes_ += count * item_bytes;
    return json_["accessors"].size() - 1;
  }

  json& accessor(std::size_t number) { return json_["accessors"][number]; }

  void add_primitive(const json& attributes, std::size_t indices, const patch& one) {
    json_["materials"].push_back(material_of(one));
    json_["meshes"][0]["primitives"].push_back({{"attributes", attributes},
                                                {"indices", indices},
                                                {"material", json_["materials"].size() - 1}});
  }

  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// Padded as the format wants it. A name that is no UTF-8 gets its signs of replacement.
  std::string text() {
    json_["buffers"] = json::array({{{"byteLength", bytes_}}});
    auto result = json_.dump(-1, ' ', false, json::error_handler_t::replace);
    result.resize((result.size() + 3) / 4 * 4, ' ');
    return result;
  }

private:
  json json_;
  std::size_t bytes_ = 0;
};

std::vector<std::array<float, 3>> positions_of(const mesh_version& mesh,
                                               const compaction& vertices) {
  std::vector<std::array<float, 3>> result;
  result.reserve(vertices.slots.size());
  for (const auto v : vertices.slots) {
    const auto p = mesh.position(v);
    result.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  return result;
}

std::vector<std::array<std::uint16_t, 4>> colours_of(const file_colours& colours,
                                                     const compaction& vertices) {
  std::vector<std::array<std::uint16_t, 4>> palette;
  for (const auto& c : colours.palette) {
    const auto share = [](std::uint8_t value) {
      return static_cast<std::uint16_t>(std::lround(light_of(value) * 65535));
    };
    palette.push_back({share(c[0]), share(c[1]), share(c[2]), 65535});
  }
  std::vector<std::array<std::uint16_t, 4>> result;
  if (!colours.of_vertices.empty())
    for (const auto v : vertices.slots)
      result.push_back(palette[colours.of_vertices[v]]);
  return result;
}

/// The format wants the box of the positions, as they are in the file.
void add_box(json& accessor, const std::vector<std::array<float, 3>>& positions) {
  std::array<float, 3> least{}, most{};
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = i == 0 ? positions[i][k] : std::min(least[k], positions[i][k]);
      most[k] = i == 0 ? positions[i][k] : std::max(most[k], positions[i][k]);
    }
  accessor["min"] = least;
  accessor["max"] = most;
}

void put_number(std::ostream& out, std::size_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  out.write(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class T>
void put_array(std::ostream& out, const std::vector<T>& items) {
  out.write(reinterpret_cast<const char*>(items.data()),
            static_cast<std::streamsize>(items.size() * sizeof(T)));
}

}  // namespace

namespace formats {

bool glb::recognises(std::span<const char> bytes) {
  return std::string_view(bytes.data(), bytes.size()).starts_with("glTF");
}

expected<void> glb::write(const file_target& to, const mesh_version& mesh,
                          const file_terms& terms) {
  const auto vertices = boundary_vertices_of_file(mesh);
  const auto positions = positions_of(mesh, vertices);
  const auto colours = colours_of(terms.colours, vertices);
  const auto patches = patches_of(mesh, terms.colours, vertices);

  document about(terms.title);
  json attributes{{"POSITION", about.add_array(positions.size(), type_float, "VEC3",
                                               sizeof positions[0], target_vertices)}};
  add_box(about.accessor(0), positions);
  if (!colours.empty()) {
    attributes["COLOR_0"] =
      about.add_array(colours.size(), type_ushort, "VEC4", sizeof colours[0], target_vertices);
    about.accessor(1)["normalized"] = true;
  }
  for (const auto& one : patches)
    about.add_primitive(attributes,
                        about.add_array(one.corners.size(), type_uint, "SCALAR",
                                        sizeof one.corners[0], target_indices),
                        one);
  const auto text = about.text();
  const auto total =
    header_bytes + chunk_header_bytes + text.size() + chunk_header_bytes + about.bytes();
  if (total > std::numeric_limits<std::uint32_t>::max())
    return fail(ec::invalid_argument, "the part is too large for a GLB file, which ends at 4 GiB",
                "Write it as .stl, or make the mesh coarser");
  return to.write([&](std::ostream& out) {
    out << "glTF";
    put_number(out, version_of_gltf);
    put_number(out, total);
    put_number(out, text.size());
    out << json_chunk << text;
    put_number(out, about.bytes());
    out << binary_chunk;
    put_array(out, positions);
    put_array(out, colours);
    for (const auto& one : patches)
      put_array(out, one.corners);
  });
}

}  // namespace formats

}  // namespace tedit
