// SPDX-License-Identifier: AGPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/export_step.hpp"
#include "cli/part_input.hpp"
#include "decks/deck_file.hpp"
#include "mesh/formats.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

struct export_options {
  part_input part;
  std::string load_case;
  std::string output;
  std::string solver = "spooles";
  int order = 2;
};

struct export_counts {
  const char* format = "calculix";
  decks::deck_counts of;
  std::string loads_are;
  std::string command;  ///< How its solver is called; empty where that depends on whose it is.
};

/// How CalculiX is called: it wants the name without its ending.
std::string call_of(const fs::path& deck) {
  return "ccx -i " + fs::path(deck).replace_extension().string();
}

nlohmann::ordered_json to_json(const export_options& options, const fem::problem& p,
                               const export_counts& counts) {
  return {{"file", options.output},
          {"format", counts.format},
          {"element_order", p.element_order},
          {"nodes", p.node_count()},
          {"elements", p.element_count()},
          {"held_nodes", counts.of.held_nodes},
          {"boundaries", counts.of.boundaries},
          {"equations", counts.of.equations},
          {"loads", counts.of.loads},
          {"command", counts.command}};
}

std::string describe(const export_options& options, const fem::problem& p,
                     const export_counts& counts) {
  const bool calculix = !counts.command.empty();
  const char* element = p.element_order == 2 ? (calculix ? " C3D10" : " CTETRA of 10 nodes")
                                             : (calculix ? " C3D4" : " CTETRA of 4 nodes");
  return options.output + "\n  elements          " + std::to_string(p.element_count()) + element +
         ", " + std::to_string(p.node_count()) + " nodes\n  supports          " +
         std::to_string(counts.of.held_nodes) + " nodes (" + std::to_string(counts.of.boundaries) +
         " components, " + std::to_string(counts.of.equations) +
         " equations)\n  loads             " + std::to_string(counts.of.loads) + " " +
         counts.loads_are + "\n" +
         (calculix ? "  run it with       " + counts.command + "\n" : std::string());
}

expected<export_counts> write_inp(const export_options& options, const decks::deck_job& job) {
  const auto counts =
    decks::write_calculix(options.output, job,
                          options.solver == "cholesky" ? fem::calculix_solver::iterative_cholesky
                                                       : fem::calculix_solver::spooles);
  if (!counts)
    return fail(counts.error());
  return export_counts{"calculix", *counts, "nodal components", call_of(options.output)};
}

/// The same for Nastran.
expected<export_counts> write_bdf(const export_options& options, const decks::deck_job& job) {
  const auto counts = decks::write_nastran(options.output, job);
  if (!counts)
    return fail(counts.error());
  return export_counts{"nastran", *counts, "nodal forces", ""};
}

/// The deck's format by its suffix: one that holds loads.
expected<const file_format*> deck_format(const std::string& file) {
  const auto suffix = fs::path(file).extension().string();
  const auto* format = format_of_suffix(std::string_view(suffix).substr(suffix.empty() ? 0 : 1));
  if (format && format->keeps.loads)
    return format;
  return fail(ec::usage, file + " does not end in .inp, .bdf, .nas or .dat",
              "CalculiX reads NAME.inp, Nastran NAME.bdf: give such a name");
}

/// A mesh, or a version of a document, and what acts on it.
struct loaded_part {
  version_ptr mesh;
  fem::load_case loads;
};

/// A document has load cases of its own: without a file or name the only one is taken.
expected<loaded_part> read_loaded(const export_options& options, session& s) {
  auto part = read_input(options.part, s);
  if (!part)
    return fail(part.error());
  auto loads = cases_of(
    options.part, *part,
    options.load_case.empty() ? std::vector<std::string>() : std::vector{options.load_case});
  if (!loads)
    return fail(loads.error());
  if (loads->size() > 1)
    return fail(ec::usage,
                options.part.file + " has " + std::to_string(loads->size()) +
                  " load cases, and a deck gets one",
                "Name one with --load-case: " + names_of(*loads));
  return loaded_part{std::move(part->mesh.version), std::move(loads->front())};
}

int run_export(const export_options& options, session& s) {
  if (is_step(options.output))
    return run_export_step({options.part.file, options.output, options.part.version}, s);
  const auto format = deck_format(options.output);
  if (!format)
    return print_error(s, format.error());
  const auto part = read_loaded(options, s);
  if (!part)
    return print_error(s, part.error());
  const auto problem = fem::make_problem(*part->mesh, part->loads, options.order);
  if (!problem)
    return print_error(s, problem.error());
  const auto job = decks::make_deck_job(
    *part->mesh, *problem, part->loads,
    part->loads.name + " on " + fs::path(options.part.file).filename().string());
  const auto counts =
    (*format)->name == formats::inp::about.name ? write_inp(options, job) : write_bdf(options, job);
  if (!counts)
    return print_error(s, counts.error());
  print_result(s, to_json(options, *problem, *counts), describe(options, *problem, *counts));
  return 0;
}

}  // namespace

void add_export(CLI::App& app, action& chosen) {
  auto options = std::make_shared<export_options>();
  auto* command = app.add_subcommand(
    "export",
    "Write a load case on a mesh as an input deck of CalculiX or Nastran, or the CAD model of a "
    "document as STEP");
  add_part_options(*command, options->part);
  command->add_option("--load-case", options->load_case,
                      "Of a deck: materials, supports and loads (JSON), or the name of one that "
                      "the document has; its only one without it");
  command
    ->add_option("-o,--output", options->output,
                 "Write here: a deck, NAME.inp for CalculiX, NAME.bdf for Nastran; or the CAD "
                 "model with all edits, NAME.step")
    ->required();
  command
    ->add_option("--order", options->order,
                 "2: quadratic tets (C3D10, CTETRA of 10 nodes); 1: linear tets")
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
