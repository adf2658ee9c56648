// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/mesh_report.hpp"
#include "cli/part_input.hpp"

namespace tedit::cli {

namespace {

struct info_options {
  part_input part;
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

std::string describe(const info_options& options, const input_part& part,
                     const mesh_report& report) {
  const auto& mesh = *part.mesh.version;
  std::string text = options.part.file + "\n";
  const auto line = [&](const std::string& label, const std::string& value) {
    text += "  " + label + std::string(18 - label.size(), ' ') + value + "\n";
  };
  if (part.number) {
    line("number", std::to_string(*part.number));
    line("load cases", names_of(part.load_cases));
  }
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
  const auto part = read_input(options.part, s);
  if (!part)
    return print_error(s, part.error());
  const auto& mesh = *part->mesh.version;
  const auto report = make_mesh_report(mesh);
  auto json = to_json(mesh, report);
  json["warnings"] = part->mesh.warnings;
  if (part->number) {
    json["number"] = *part->number;
    json["load_cases"] = nlohmann::ordered_json::array();
    for (const auto& one : part->load_cases)
      json["load_cases"].push_back(one.name);
  }
  print_result(s, json, describe(options, *part, report));
  return 0;
}

}  // namespace

void add_info(CLI::App& app, action& chosen) {
  auto options = std::make_shared<info_options>();
  auto* command = app.add_subcommand("info", "Say what is in a mesh file or a document");
  add_part_options(*command, options->part);
  command->add_flag("--all", options->all, "List all surfaces, however many there are");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_info(*options, s); }; });
}

}  // namespace tedit::cli
