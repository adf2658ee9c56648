// SPDX-License-Identifier: AGPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <set>

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
  std::vector<std::string> load_cases;
  std::string output;
  std::string length_unit = "mm";
  std::string device = "auto";
  double tolerance = 1e-6;
  double energy_tolerance = 0;
  int order = 2;
};

std::string preview_text(const solve_report& report) {
  if (report.element_order < 2)
    return "  PREVIEW: linear tets are too stiff in bending; displacements of thin parts can be\n"
           "  several times too small.\n";
  return "  PREVIEW: stopped at the energy tolerance, before the residual's.\n";
}

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

std::string time_line(double total_ms, double import_ms, double assembly_ms, double solve_ms,
                      double recovery_ms) {
  return "  time              " + pretty(total_ms) + " ms (import " + pretty(import_ms, 3) +
         ", assembly " + pretty(assembly_ms, 3) + ", solve " + pretty(solve_ms, 4) + ", recovery " +
         pretty(recovery_ms, 3) + ")\n";
}

std::string describe(const timed_report& timed) {
  const auto& report = timed.report;
  auto text = cli::describe(report);
  text += time_line(report.total_ms, timed.import_ms, report.assembly_ms, report.solve_ms,
                    report.recovery_ms) +
          remarks(report);
  if (report.preview)
    text += preview_text(report);
  return text;
}

/// Reads all load cases. Several have names of their own: a case without one is called after its
/// file, and a name that was there before gets a number.
expected<std::vector<fem::load_case>> read_cases(const std::vector<std::string>& files) {
  std::vector<fem::load_case> cases;
  std::set<std::string> names;
  for (const auto& file : files) {
    auto one = protocol::load_case_from_file(file);
    if (!one)
      return fail(one.error());
    if (files.size() > 1) {
      if (one->name.empty())
        one->name = std::filesystem::path(file).stem().string();
      const auto name = one->name;
      for (int i = 2; !names.insert(one->name).second; ++i)
        one->name = name + " " + std::to_string(i);
    }
    cases.push_back(std::move(*one));
  }
  return cases;
}

/// What solving and reporting have in common, however many load cases there are.
struct solve_run {
  const solve_options& options;
  session& s;
  const mesh_version& mesh;
  stopwatch total;
  double import_ms = 0;
};

fem::solve_settings settings_of(const solve_options& options) {
  fem::solve_settings settings;
  settings.tolerance = options.tolerance;
  settings.energy_tolerance = options.energy_tolerance;
  return settings;
}

void print_together(const solve_run& run, const fem::case_set& set, const fem::solved_cases& result,
                    double problem_ms) {
  std::vector<solve_report> reports;
  for (std::size_t c = 0; c < result.cases.size(); ++c)
    reports.push_back(make_report(run.mesh, set.cases[c].name, set.problem, result.cases[c]));
  auto json = cli::to_json(reports, result.envelope);
  const double total_ms = run.total.milliseconds();
  json["timings_ms"] = {{"import", run.import_ms},
                        {"assembly", result.assembly_ms},
                        {"setup", result.setup_ms + problem_ms},
                        {"solve", result.solve_ms},
                        {"recovery", result.recovery_ms},
                        {"total", total_ms}};
  auto text =
    cli::describe(reports, result.envelope) +
    time_line(total_ms, run.import_ms, result.assembly_ms, result.solve_ms, result.recovery_ms);
  if (reports.front().preview)
    text += preview_text(reports.front());
  print_result(run.s, json, text);
}

/// Several load cases on one matrix.
int solve_together(const solve_run& run, const std::vector<fem::load_case>& loads) {
  stopwatch clock;
  auto set = fem::make_cases(run.mesh, loads, run.options.order);
  if (!set)
    return print_error(run.s, set.error());
  const double problem_ms = clock.milliseconds();
  const auto device = fem::open_backend(run.options.device);
  if (!device)
    return print_error(run.s, device.error());
  const auto result =
    fem::solve_cases(*set, **device, settings_of(run.options), make_execution(run.s));
  if (!result)
    return print_error(run.s, result.error());
  if (!run.options.output.empty())
    if (auto written = write_field(run.options.output, run.mesh, *set, *result); !written)
      return print_error(run.s, written.error());
  print_together(run, *set, *result, problem_ms);
  return 0;
}

int run_solve(const solve_options& options, session& s) {
  const stopwatch total;
  stopwatch clock;
  timed_report timed;
  const auto loads = read_cases(options.load_cases);
  if (!loads)
    return print_error(s, loads.error());
  const auto imported = import_mesh(options.mesh, options.length_unit);
  if (!imported)
    return print_error(s, imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  const auto& mesh = *imported->version;
  timed.import_ms = clock.restart();
  if (loads->size() > 1)
    return solve_together({options, s, mesh, total, timed.import_ms}, *loads);

  const auto problem = fem::make_problem(mesh, loads->front(), options.order);
  if (!problem)
    return print_error(s, problem.error());
  const double problem_ms = clock.restart();
  const auto device = fem::open_backend(options.device);
  if (!device)
    return print_error(s, device.error());
  const auto result = fem::solve(*problem, **device, settings_of(options), make_execution(s));
  if (!result)
    return print_error(s, result.error());
  if (!options.output.empty())
    if (auto written = write_field(options.output, mesh, *problem, *result); !written)
      return print_error(s, written.error());
  timed.report = make_report(mesh, loads->front().name, *problem, *result);
  timed.report.setup_ms += problem_ms;
  timed.report.total_ms = total.milliseconds();
  print_result(s, to_json(timed), describe(timed));
  return 0;
}

}  // namespace

void add_solve(CLI::App& app, action& chosen) {
  auto options = std::make_shared<solve_options>();
  auto* command = app.add_subcommand("solve", "Solve load cases on a mesh");
  command->add_option("mesh", options->mesh, "A Gmsh file (MSH 2.2 or 4.1)")->required();
  command
    ->add_option("--load-case", options->load_cases,
                 "Materials, supports and loads (JSON); again for more load cases, which are "
                 "solved together and get an envelope")
    ->required()
    ->allow_extra_args(false);
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
    ->add_option(
      "--energy-tolerance", options->energy_tolerance,
      "Stop already when the estimated relative error in energy is below this: a preview")
    ->check(CLI::Range(1e-9, 0.5));
  command
    ->add_option("--order", options->order,
                 "2: quadratic tets; 1: linear tets, a quick preview that is too stiff in bending")
    ->check(CLI::IsMember({1, 2}))
    ->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_solve(*options, s); }; });
}

}  // namespace tedit::cli
