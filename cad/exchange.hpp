// SPDX-License-Identifier: AGPL-3.0-or-later
// What passes between `tedit import` and its two programs, in files of a folder that only the three
// know. Each program tells on its stdout, line by line, what it is doing: a program that dies has
// said where.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace tedit::cad {

// Files of the folder.
inline constexpr const char* shape_file = "part.brep";         ///< Solids in mm; the reader's.
inline constexpr const char* facts_file = "part.json";         ///< `part_facts`; the reader's.
inline constexpr const char* geometry_file = "part.geometry";  ///< `save_geometries`; the reader's.
inline constexpr const char* mesh_file = "part.mesh";          ///< `mesh_header`; the mesher's.
inline constexpr const char* report_file = "mesh.json";        ///< `mesh_report`; the mesher's.
inline constexpr const char* log_file = "messages.txt";        ///< What libraries print.
inline constexpr const char* plain_file = "without.step";      ///< The part without annotations.
inline constexpr const char* step_output = "out.step";         ///< The writer's.

/// How the layer of a face begins that says its surfaces in the mesh: "tedit surface 12, 13".
inline constexpr std::string_view layer_of_surfaces = "tedit surface ";

using colour = std::array<double, 3>;  ///< sRGB, 0 to 1.

/// A face of the part, in the order in which they are met: that of surface ids, from 1.
struct face_facts {
  std::string name;  ///< As the file has it; empty: none.
  std::optional<colour> looks;
  double area_mm2 = 0;
  std::vector<int> ids = {};  ///< Its surfaces in the mesh: several where an edit made them one.
};

/// A solid, in the order of region ids, from 1.
struct solid_facts {
  std::string name;
  std::optional<colour> looks;
  double volume_mm3 = 0;
  double area_mm2 = 0;
};

struct part_facts {
  std::string length_unit;  ///< Of the CAD file: "mm", "in".
  std::vector<face_facts> faces;
  std::vector<solid_facts> solids;
  std::vector<std::string> notices;
};

/// As JSON, as they are kept in documents.
[[nodiscard]] std::string to_text(const part_facts& facts);
/// The inverse. Errors: `internal`.
[[nodiscard]] expected<part_facts> facts_from(std::string_view text);

/// Errors: `io_error`, `internal` for a file that no reader wrote.
[[nodiscard]] expected<part_facts> load_facts(const std::filesystem::path& folder);
[[nodiscard]] bool save_facts(const part_facts& facts, const std::filesystem::path& folder);

/// Before the points (3 doubles each, mm), triangles (3 indices and a surface id, 32 bits each) and
/// tets (4 indices and a region id).
struct mesh_header {
  std::uint64_t magic = 0x314D444143455454;
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  std::uint64_t tets = 0;
};

struct mesh_report {
  double size_mm = 0;  ///< The largest edge length that was asked for.
  std::size_t collapsed = 0;
  std::size_t flipped = 0;
  double moved_mm = 0;    ///< How far the surface is off the mesher's at most.
  std::vector<int> gone;  ///< Surfaces too small to be meshed.
};

[[nodiscard]] expected<mesh_report> load_report(const std::filesystem::path& folder);
[[nodiscard]] bool save_report(const mesh_report& report, const std::filesystem::path& folder);

}  // namespace tedit::cad
