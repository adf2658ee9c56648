// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>
#include <ostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/colours.hpp"
#include "cli/command.hpp"
#include "cli/deck_loads.hpp"
#include "cli/part_input.hpp"
#include "mesh/io/formats.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

namespace {

struct convert_options {
  part_input part;
  std::string output;
  std::string output_unit;  ///< Empty: as in the mesh.
  std::string load_case;    ///< Where that of a deck is written to.
  std::string colour;       ///< Empty: none.
};

/// What of the mesh is not in the file.
std::string losses_of(const file_format& format) {
  if (format.keeps.tets)
    return format.keeps.surfaces ? "" : ", without its surfaces";
  return std::string(", its boundary alone") +
         (format.keeps.surfaces ? "" : ", without its surfaces");
}

/// The deck's, or that of a document. Errors: `not_found` where there is none; `usage` for several.
expected<fem::deck_case> only_case(const convert_options& options, const input_part& part) {
  if (!part.number)
    return load_case_of(part.mesh);
  if (part.load_cases.size() == 1)
    return fem::deck_case{part.load_cases.front(), {}};
  return fail(part.load_cases.empty() ? ec::not_found : ec::usage,
              options.part.file + " has " + std::to_string(part.load_cases.size()) +
                " load cases, and the file gets one",
              "Leave out --load-case; \"tedit info\" names those that there are");
}

/// Writes the load case, or says that the new file has none of it.
expected<void> write_loads(const convert_options& options, const input_part& part, const session& s,
                           nlohmann::ordered_json& result) {
  if (options.load_case.empty()) {
    if (!part.mesh.loads.empty() || !part.load_cases.empty())
      notice(s,
             "note: materials, supports and loads of the file are not in the new one; "
             "--load-case FILE.json keeps them");
    return {};
  }
  const auto loads = only_case(options, part);
  if (!loads)
    return fail(loads.error());
  for (const auto& remark : loads->remarks)
    notice(s, "note: " + remark);
  const auto text = protocol::load_case_to_json(loads->loads) + "\n";
  result["load_case"] = options.load_case;
  result["left_out"] = loads->remarks;
  return write_file(options.load_case, [&](std::ostream& out) { out << text; });
}

/// That of the mesh, where the new file is a mesh that says it; else the one that whoever reads it
/// will assume.
std::string unit_of_output(const convert_options& options, const imported_mesh& mesh,
                           const kept_in_file& keeps) {
  if (!options.output_unit.empty())
    return options.output_unit;
  return keeps.unit && keeps.tets ? mesh.length_unit : options.part.length_unit;
}

expected<part_looks> looks_of(const convert_options& options, const file_format& format,
                              const mesh_version& mesh) {
  if (options.colour.empty())
    return part_looks{};
  if (!format.keeps.colours)
    return fail(ec::usage, "a ." + std::string(format.name) + " file has no colours",
                "Write " + coloured_formats_text() + ", or leave out --colour");
  return make_looks(mesh, options.part.file, options.colour);
}

std::string text_of_files(const convert_options& options, const file_format& format,
                          const part_looks& looks) {
  auto text = options.output + ": the mesh" + losses_of(format) + describe(looks) + "\n";
  if (!options.load_case.empty())
    text += options.load_case + ": its materials, supports and loads\n";
  return text;
}

int run_convert(const convert_options& options, session& s) {
  const auto format = output_format(options.output);
  if (!format)
    return print_error(s, format.error());
  const auto part = read_input(options.part, s);
  if (!part)
    return print_error(s, part.error());
  const auto& mesh = *part->mesh.version;
  const auto& keeps = (*format)->keeps;
  const auto unit = unit_of_output(options, part->mesh, keeps);
  nlohmann::ordered_json result{{"file", options.output},
                                {"format", (*format)->name},
                                {"length_unit", unit},
                                {"keeps", {{"tets", keeps.tets}, {"surfaces", keeps.surfaces}}},
                                {"notes", part->mesh.warnings}};
  auto looks = looks_of(options, **format, mesh);
  if (!looks)
    return print_error(s, looks.error());
  if (const auto ok = write_loads(options, *part, s, result); !ok)
    return print_error(s, ok.error());
  const auto written =
    write_as((*format)->name, options.output, mesh,
             {.length_unit = unit,
              .colours = std::move(looks->colours),
              .title = std::filesystem::path(options.part.file).stem().string()});
  if (!written)
    return print_error(s, written.error());
  if (!options.colour.empty())
    result["colours"] = to_json(*looks);
  print_result(s, result, text_of_files(options, **format, *looks));
  return 0;
}

}  // namespace

void add_convert(CLI::App& app, action& chosen) {
  auto options = std::make_shared<convert_options>();
  auto* command = app.add_subcommand("convert", "Write a mesh as a file of another format");
  add_part_options(*command, options->part,
                   "Unit of the mesh's coordinates, where the file does not say it");
  command->add_option("-o,--output", options->output, "The new file: " + written_formats_text())
    ->required();
  command->add_option(
    "--output-unit", options->output_unit,
    "Unit of the new file's coordinates; not given: as in the mesh where the new "
    "file is a mesh that says its unit, else that of --length-unit; a file for fields is always "
    "in metres");
  command->add_option("--colour", options->colour,
                      "Colours for " + coloured_formats_text() +
                        ": \"surface\", one for each, or a field of a mesh "
                        "that \"tedit solve -o FILE.vtu\" wrote, as von_mises");
  command->add_option("--load-case", options->load_case,
                      "Write materials, supports and loads of a deck here (JSON)");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_convert(*options, s); }; });
}

}  // namespace tedit::cli
