// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "fem/load_case.hpp"
#include "mesh/io/import.hpp"

namespace tedit::cli {

/// The part that a command works on: a mesh file, or a version of a document.
struct part_input {
  std::string file;
  std::string length_unit = "mm";        ///< Of a file's coordinates, where it does not say it.
  std::optional<std::uint32_t> version;  ///< Of a document; the current one without it.
};

/// The positional "mesh", --version and --length-unit.
void add_part_options(CLI::App& command, part_input& input,
                      const std::string& unit_help = "Unit of the file's coordinates");

struct input_part {
  imported_mesh mesh;
  std::vector<fem::load_case> load_cases;  ///< A document's own.
  std::optional<std::uint32_t> number;     ///< Of a document: that of the version.
};

/// Reads it, and says on stderr what a person should know of the file. Errors: those of
/// `import_mesh` and `read_version_of`; `usage` for a version of a mesh file.
[[nodiscard]] expected<input_part> read_input(const part_input& input, const session& s);

/// The load cases that a command is told: the files' (`read_load_cases`), where a word is the name
/// of one that the document has that one, and without any all of the document's. Errors: those of
/// the files; `usage` where there is none.
[[nodiscard]] expected<std::vector<fem::load_case>> cases_of(const part_input& input,
                                                             const input_part& part,
                                                             const std::vector<std::string>& told);

/// "braking, lifting", or "none".
[[nodiscard]] std::string names_of(const std::vector<fem::load_case>& load_cases);

/// Help for the --load-case that is read so.
inline constexpr const char* load_case_help =
  "Materials, supports and loads (JSON), or the name of one that the document has; again for more. "
  "All of a document's without it";

}  // namespace tedit::cli
