// SPDX-License-Identifier: AGPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <ostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "fem/calculix_deck.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

struct export_options {
  std::string mesh;
  std::string load_case;
  std::string output;
  std::string length_unit = "mm";
  std::string solver = "spooles";
  int order = 2;
};

/// How CalculiX is called: it wants the name without its ending.
std::string call_of(const fs::path& deck) {
  return "ccx -i " + fs::path(deck).replace_extension().string();
}

nlohmann::ordered_json to_json(const export_options& options, const fem::problem& p,
                               const fem::calculix_counts& counts) {
  return {{"file", options.output},
          {"format", "calculix"},
          {"element_order", p.element_order},
          {"nodes", p.node_count()},
          {"elements", p.element_count()},
          {"held_nodes", counts.held_nodes},
          {"boundaries", counts.boundaries},
          {"equations", counts.equations},
          {"loads", counts.loads},
          {"command", call_of(options.output)}};
}

std::string describe(const export_options& options, const fem::problem& p,
                     const fem::calculix_counts& counts) {
  return options.output + "\n  elements          " + std::to_string(p.element_count()) +
         (p.element_order == 2 ? " C3D10" : " C3D4") + ", " + std::to_string(p.node_count()) +
         " nodes\n  supports          " + std::to_string(counts.held_nodes) + " nodes (" +
         std::to_string(counts.boundaries) + " components, " + std::to_string(counts.equations) +
         " equations)\n  loads             " + std::to_string(counts.loads) +
         " nodal components\n  run it with       " + call_of(options.output) + "\n";
}

int run_export(const export_options& options, session& s) {
  if (fs::path(options.output).extension() != ".inp")
    return print_error(s, {ec::usage,
                           options.output + " does not end in .inp",
                           "CalculiX reads NAME.inp: give such a name",
                           {}});
  const auto loads = protocol::load_case_from_file(options.load_case);
  if (!loads)
    return print_error(s, loads.error());
  const auto imported = import_mesh(options.mesh, options.length_unit);
  if (!imported)
    return print_error(s, imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  const auto problem = fem::make_problem(*imported->version, *loads, options.order);
  if (!problem)
    return print_error(s, problem.error());
  fem::calculix_settings settings;
  settings.title = loads->name + " on " + fs::path(options.mesh).filename().string();
  if (options.solver == "cholesky")
    settings.solver = fem::calculix_solver::iterative_cholesky;
  fem::calculix_counts counts;
  const auto written = write_file(options.output, [&](std::ostream& out) {
    counts = fem::write_calculix_deck(*problem, settings, out);
  });
  if (!written)
    return print_error(s, written.error());
  print_result(s, to_json(options, *problem, counts), describe(options, *problem, counts));
  return 0;
}

}  // namespace

void add_export(CLI::App& app, action& chosen) {
  auto options = std::make_shared<export_options>();
  auto* command =
    app.add_subcommand("export", "Write a load case on a mesh as an input deck of CalculiX");
  command->add_option("mesh", options->mesh, "A Gmsh file (MSH 2.2 or 4.1)")->required();
  command->add_option("--load-case", options->load_case, "Materials, supports and loads (JSON)")
    ->required();
  command->add_option("-o,--output", options->output, "Write the deck here (NAME.inp)")->required();
  command->add_option("--length-unit", options->length_unit, "Unit of the file's coordinates")
    ->capture_default_str();
  command->add_option("--order", options->order, "2: quadratic tets (C3D10); 1: linear tets (C3D4)")
    ->check(CLI::IsMember({1, 2}))
    ->capture_default_str();
  command
    ->add_option("--solver", options->solver,
                 "What CalculiX solves with: spooles (direct) or cholesky (iterative, less memory)")
    ->check(CLI::IsMember({"spooles", "cholesky"}))
    ->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_export(*options, s); }; });
}

}  // namespace tedit::cli
