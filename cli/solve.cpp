// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/field_file.hpp"
#include "cli/reports.hpp"
#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

namespace {

struct solve_options {
  std::string mesh;
  std::string load_case;
  std::string output;
  std::string length_unit = "mm";
  std::string device = "auto";
  double tolerance = 1e-6;
  int order = 2;
};

/// A report with the caller's times in it.
struct timed_report {
  solve_report report;
  double import_ms = 0;
};

nlohmann::ordered_json to_json(const timed_report& timed) {
  auto json = cli::to_json(timed.report);
  json["timings_ms"]["import"] = timed.import_ms;
  return json;
}

std::string describe(const timed_report& timed) {
  const auto& report = timed.report;
  auto text = cli::describe(report);
  text += "  time              " + pretty(report.total_ms) + " ms (import " +
          pretty(timed.import_ms, 3) + ", assembly " + pretty(report.assembly_ms, 3) + ", solve " +
          pretty(report.solve_ms, 4) + ", recovery " + pretty(report.recovery_ms, 3) + ")\n" +
          remarks(report);
  if (report.preview)
    text +=
      "  PREVIEW: linear tets are too stiff in bending; displacements of thin parts can be\n"
      "  several times too small.\n";
  return text;
}

int run_solve(const solve_options& options, session& s) {
  const stopwatch total;
  stopwatch clock;
  timed_report timed;
  const auto loads = protocol::load_case_from_file(options.load_case);
  if (!loads)
    return print_error(s, loads.error());
  const auto imported = import_mesh(options.mesh, options.length_unit);
  if (!imported)
    return print_error(s, imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  const auto& mesh = *imported->version;
  timed.import_ms = clock.restart();

  const auto problem = fem::make_problem(mesh, *loads, options.order);
  if (!problem)
    return print_error(s, problem.error());
  const double problem_ms = clock.restart();
  const auto device = fem::open_backend(options.device);
  if (!device)
    return print_error(s, device.error());
  fem::solve_settings settings;
  settings.tolerance = options.tolerance;
  const auto result = fem::solve(*problem, **device, settings, make_execution(s));
  if (!result)
    return print_error(s, result.error());
  if (!options.output.empty())
    if (auto written = write_field(options.output, mesh, *problem, *result); !written)
      return print_error(s, written.error());
  timed.report = make_report(mesh, loads->name, *problem, *result);
  timed.report.setup_ms += problem_ms;
  timed.report.total_ms = total.milliseconds();
  print_result(s, to_json(timed), describe(timed));
  return 0;
}

}  // namespace

void add_solve(CLI::App& app, action& chosen) {
  auto options = std::make_shared<solve_options>();
  auto* command = app.add_subcommand("solve", "Solve a load case on a mesh");
  command->add_option("mesh", options->mesh, "A Gmsh file (MSH 2.2 or 4.1)")->required();
  command->add_option("--load-case", options->load_case, "Materials, supports and loads (JSON)")
    ->required();
  command->add_option("-o,--output", options->output, "Write the fields to this VTU file");
  command->add_option("--length-unit", options->length_unit, "Unit of the file's coordinates")
    ->capture_default_str();
  command
    ->add_option("--device", options->device,
                 "cpu, lavapipe, auto (the fastest by a short trial) or part of a device's name")
    ->capture_default_str();
  command->add_option("--tolerance", options->tolerance, "True relative residual to reach")
    ->check(CLI::Range(1e-12, 1e-1))
    ->capture_default_str();
  command
    ->add_option("--order", options->order,
                 "2: quadratic tets; 1: linear tets, a quick preview that is too stiff in bending")
    ->check(CLI::IsMember({1, 2}))
    ->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_solve(*options, s); }; });
}

}  // namespace tedit::cli
