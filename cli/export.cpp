// SPDX-License-Identifier: AGPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/part_document.hpp"
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
  std::optional<std::uint32_t> version;
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

bool is_step(const fs::path& file) {
  const auto suffix = file.extension();
  return suffix == ".step" || suffix == ".stp";
}

/// The CAD model of a document's version.
int run_export_step(const export_options& options, session& s) {
  if (!is_document(options.mesh))
    return print_error(s, {ec::usage,
                           options.mesh + " is no document: a mesh has no CAD model",
                           "Begin with \"tedit import PART.step -o PART.tedit\", and edit that",
                           {}});
  const auto run = make_execution(s);
  const auto part = read_part(options.mesh, options.version, run.part(0, 0.5));
  if (!part)
    return print_error(s, part.error());
  if (!part->cad)
    return print_error(s, {ec::not_found,
                           options.mesh + " has no CAD model: the part came from a mesh",
                           "Begin with \"tedit import PART.step -o PART.tedit\", and edit that",
                           {}});
  if (!part->cad->model)
    return print_error(s, {ec::not_found,
                           "the CAD model is older than version " + std::to_string(part->number) +
                             ": " + part->cad->reason,
                           "Export an earlier version with --version, or the mesh "
                           "(\"tedit doc export\")",
                           {}});
  const auto& model = *part->cad->model;
  if (auto written = cad::write_step(model, options.output, {}, run.part(0.5, 1)); !written)
    return print_error(s, written.error());
  print_result(s,
               {{"file", options.output},
                {"format", "step"},
                {"version", part->number},
                {"solids", model.facts.solids.size()},
                {"faces", model.facts.faces.size()},
                {"deviation_m", part->cad->deviation_m}},
               options.output + ": " + std::to_string(model.facts.solids.size()) + " solids, " +
                 std::to_string(model.facts.faces.size()) + " faces, version " +
                 std::to_string(part->number) + "\n");
  return 0;
}

int run_export(const export_options& options, session& s) {
  if (is_step(options.output))
    return run_export_step(options, s);
  if (options.load_case.empty())
    return print_error(s, {ec::usage,
                           "--load-case is missing",
                           "A deck has materials, supports and loads: name their file",
                           {}});
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
    app.add_subcommand("export",
                       "Write a load case on a mesh as an input deck of CalculiX, or the CAD model "
                       "of a document as STEP");
  command
    ->add_option("mesh", options->mesh,
                 "A Gmsh file (MSH 2.2 or 4.1); for STEP a document (.tedit)")
    ->required();
  command->add_option("--load-case", options->load_case,
                      "Of a deck: materials, supports and loads (JSON)");
  command
    ->add_option("-o,--output", options->output,
                 "Write here: a deck (NAME.inp), or the CAD model with all edits (NAME.step)")
    ->required();
  command->add_option("--version", options->version,
                      "Of a document: the version's number; the current one without it");
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
