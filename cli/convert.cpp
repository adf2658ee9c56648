// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"

namespace tedit::cli {

namespace {

struct convert_options {
  std::string mesh;
  std::string output;
  std::string length_unit = "mm";
  std::string output_unit;  ///< Empty: as in the mesh.
};

/// What of the mesh is not in the file.
std::string losses_of(const file_format& format) {
  if (format.keeps.tets)
    return format.keeps.surfaces ? "" : ", without its surfaces";
  return std::string(", its boundary alone") +
         (format.keeps.surfaces ? "" : ", without its surfaces");
}

int run_convert(const convert_options& options, session& s) {
  const auto format = output_format(options.output);
  if (!format)
    return print_error(s, format.error());
  const auto imported = import_mesh(options.mesh, options.length_unit);
  if (!imported)
    return print_error(s, imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  const auto& unit = options.output_unit.empty() ? options.length_unit : options.output_unit;
  const auto written =
    write_as((*format)->name, options.output, *imported->version, {.length_unit = unit});
  if (!written)
    return print_error(s, written.error());
  print_result(
    s,
    {{"file", options.output},
     {"format", (*format)->name},
     {"keeps", {{"tets", (*format)->keeps.tets}, {"surfaces", (*format)->keeps.surfaces}}}},
    options.output + ": the mesh" + losses_of(**format) + "\n");
  return 0;
}

}  // namespace

void add_convert(CLI::App& app, action& chosen) {
  auto options = std::make_shared<convert_options>();
  auto* command = app.add_subcommand("convert", "Write a mesh as a file of another format");
  command->add_option("mesh", options->mesh, "A Gmsh file (MSH 2.2 or 4.1)")->required();
  command->add_option("-o,--output", options->output, "The new file: " + written_formats_text())
    ->required();
  command->add_option("--length-unit", options->length_unit, "Unit of the mesh's coordinates")
    ->capture_default_str();
  command->add_option("--output-unit", options->output_unit,
                      "Unit of the new file's coordinates, as in the mesh when it is not given; a "
                      "file for fields is always in metres");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_convert(*options, s); }; });
}

}  // namespace tedit::cli
