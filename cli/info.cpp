// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/mesh_report.hpp"
#include "mesh/formats.hpp"
#include "mesh/io/import.hpp"

namespace tedit::cli {

namespace {

struct info_options {
  std::string mesh;
  std::string length_unit = "mm";
  bool all = false;
};

/// Longer tables are cut, unless all was asked for.
constexpr std::size_t most_rows = 50;

std::string surface_table(const mesh_report& report, bool all) {
  const auto& surfaces = report.surfaces;
  const auto count = all ? surfaces.size() : std::min(surfaces.size(), most_rows);
  std::vector<std::vector<std::string>> rows{{"surface", "facets", "area mm2", "shape", "name"}};
  for (std::size_t i = 0; i < count; ++i) {
    const auto& row = surfaces[i];
    rows.push_back({std::to_string(row.id), std::to_string(row.facets + row.interface_facets),
                    pretty(1e6 * row.area_m2, 6), shape_words(row), row.name});
  }
  auto text = format_table(rows, {3, 4});
  if (count < surfaces.size())
    text += "  ... and " + std::to_string(surfaces.size() - count) +
            " more: --all lists them, \"tedit select\" finds holes and ribs\n";
  return text;
}

std::string describe(const info_options& options, const imported_mesh& imported,
                     const mesh_report& report) {
  const auto& mesh = *imported.version;
  std::string text = options.mesh + "\n";
  const auto line = [&](const std::string& label, const std::string& value) {
    text += "  " + label + std::string(18 - label.size(), ' ') + value + "\n";
  };
  line("version", to_hex(mesh.id()));
  line("tets", std::to_string(mesh.tet_count()));
  line("vertices", std::to_string(mesh.vertex_count()));
  line("boundary facets", std::to_string(mesh.facet_count()));
  line("surfaces", std::to_string(report.surfaces.size()));
  line("regions", std::to_string(mesh.regions().size()));
  line("volume", pretty(report.volume_m3 * 1e9, 6) + " mm3");
  line("size", pretty(report.size_m.x * 1e3) + " x " + pretty(report.size_m.y * 1e3) + " x " +
                 pretty(report.size_m.z * 1e3) + " mm");
  line("radius ratio", "min " + pretty(report.quality.min) + ", median " +
                         pretty(report.quality.median) + ", max " + pretty(report.quality.max));
  return text + "\n" + surface_table(report, options.all);
}

int run_info(const info_options& options, session& s) {
  const auto imported = import_mesh(options.mesh, options.length_unit);
  if (!imported)
    return print_error(s, imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  const auto report = make_mesh_report(*imported->version);
  auto json = to_json(*imported->version, report);
  json["warnings"] = imported->warnings;
  print_result(s, json, describe(options, *imported, report));
  return 0;
}

}  // namespace

void add_info(CLI::App& app, action& chosen) {
  auto options = std::make_shared<info_options>();
  auto* command = app.add_subcommand("info", "Say what is in a mesh file");
  command->add_option("mesh", options->mesh, read_formats_text())->required();
  command->add_option("--length-unit", options->length_unit, "Unit of the file's coordinates")
    ->capture_default_str();
  command->add_flag("--all", options->all, "List all surfaces, however many there are");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_info(*options, s); }; });
}

}  // namespace tedit::cli
