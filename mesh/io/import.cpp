// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/import.hpp"

#include <new>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "mesh/build_version.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {

expected<imported_mesh> import_mesh(const std::filesystem::path& path,
                                    const std::string& length_unit) {
  const stopwatch clock;
  const auto bytes = read_file(path);
  if (!bytes)
    return fail(bytes.error());
  const double file_ms = clock.milliseconds();
  auto result = import_mesh_bytes(std::span<const char>(*bytes), length_unit);
  if (!result) {
    auto failure = result.error();
    failure.where = path.string() + (failure.where.empty() ? "" : ", " + failure.where);
    return fail(std::move(failure));
  }
  result->read_ms += file_ms;
  return result;
}

namespace {

/// Bytes of a surface's or region's name that are kept; Gmsh's own have 127 at most.
constexpr std::size_t longest_name = 200;

expected<imported_mesh> read_and_build(std::span<const char> bytes,
                                       const std::string& length_unit) {
  const auto unit = metres_per_unit(length_unit);
  if (!unit)
    return fail(unit.error());
  stopwatch clock;
  auto read = read_any(bytes);
  if (!read)
    return fail(read.error());
  imported_mesh result;
  result.read_ms = clock.restart();
  // Names go into files and messages that must be UTF-8, and old files hold what they like.
  for (auto& surface : read->mesh.surface_names)
    surface.name = cut_text(to_utf8(surface.name), longest_name);
  for (auto& region : read->mesh.region_names)
    region.name = cut_text(to_utf8(region.name), longest_name);
  auto built = build_version(std::move(read->mesh), *unit, slot_order::along_curve);
  if (!built)
    return fail(built.error());
  result.build_ms = clock.restart();
  result.version = std::move(built->version);
  result.warnings = std::move(read->notices);
  result.warnings.insert(result.warnings.end(), built->warnings.begin(), built->warnings.end());
  return result;
}

}  // namespace

expected<imported_mesh> import_mesh_bytes(std::span<const char> bytes,
                                          const std::string& length_unit) {
  try {
    return read_and_build(bytes, length_unit);
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, "there is not enough memory for this mesh",
                "Close other programs or take a coarser mesh");
  }
}

}  // namespace tedit
