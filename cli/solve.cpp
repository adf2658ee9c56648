// SPDX-License-Identifier: AGPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <ostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/field_file.hpp"
#include "cli/number_option.hpp"
#include "cli/part_input.hpp"
#include "cli/reports.hpp"
#include "cli/solver_options.hpp"
#include "fem/frd_writer.hpp"
#include "fem/make_report.hpp"
#include "fem/solver.hpp"
#include "mesh/io/file.hpp"

namespace tedit::cli {

namespace {

struct solve_options {
  part_input part;
  std::vector<std::string> load_cases;
  std::string output;
  solver_options solver;
  double energy_tolerance = 0;
};

/// Of the whole solve, whether one load case or several.
struct solve_times {
  double import_ms = 0;
  double assembly_ms = 0;
  double setup_ms = 0;
  double solve_ms = 0;
  double recovery_ms = 0;
  double device_ms = 0;  ///< To find it, and with "auto" to see whether the kept choice holds.
  double total_ms = 0;
};

nlohmann::ordered_json to_json(const solve_outcome& outcome, const solve_times& times) {
  auto json = cli::to_json(outcome);
  json["timings_ms"] = {{"import", times.import_ms},     {"assembly", times.assembly_ms},
                        {"setup", times.setup_ms},       {"solve", times.solve_ms},
                        {"recovery", times.recovery_ms}, {"device", times.device_ms},
                        {"total", times.total_ms}};
  return json;
}

std::string describe(const solve_outcome& outcome, const solve_times& times) {
  auto text = cli::describe(outcome) + "  time              " + pretty(times.total_ms) +
              " ms (import " + pretty(times.import_ms, 3) + ", device " +
              pretty(times.device_ms, 3) + ", assembly " + pretty(times.assembly_ms, 3) +
              ", set-up " + pretty(times.setup_ms, 3) + ", solve " + pretty(times.solve_ms, 4) +
              ", recovery " + pretty(times.recovery_ms, 3) + ")\n";
  if (!outcome.envelope)
    text += remarks(outcome.cases.front());
  return text + preview_text(outcome);
}

fem::solve_settings settings_of(const solve_options& options) {
  fem::solve_settings settings;
  settings.tolerance = options.solver.tolerance;
  settings.energy_tolerance = options.energy_tolerance;
  return settings;
}

/// The suffix of results as CalculiX has them.
bool is_frd(const std::filesystem::path& file) {
  const auto suffix = file.extension();
  return suffix == ".frd" || suffix == ".FRD";
}

expected<void> write_results(const std::filesystem::path& file, const fem::case_set& set,
                             const fem::solved_cases& result) {
  std::vector<const fem::solution*> cases;
  std::vector<std::string> names;
  for (std::size_t c = 0; c < result.cases.size(); ++c) {
    cases.push_back(&result.cases[c]);
    names.push_back(set.cases[c].name);
  }
  return write_file(file, [&](std::ostream& out) { write_frd(set.problem, cases, names, out); });
}

expected<void> write_output(const solve_options& options, const mesh_version& mesh,
                            const fem::case_set& set, const fem::solved_cases& result) {
  if (options.output.empty())
    return {};
  if (is_frd(options.output))
    return write_results(options.output, set, result);
  if (result.cases.size() == 1)
    return write_field(options.output, mesh, set.problem, result.cases.front());
  return write_field(options.output, mesh, set, result);
}

int run_solve(const solve_options& options, session& s) {
  const stopwatch total;
  stopwatch clock;
  const auto part = read_input(options.part, s);
  if (!part)
    return print_error(s, part.error());
  const auto loads = cases_of(options.part, *part, options.load_cases);
  if (!loads)
    return print_error(s, loads.error());
  const auto& mesh = *part->mesh.version;
  const double import_ms = clock.restart();
  auto set = fem::make_cases(mesh, *loads, options.solver.order);
  if (!set)
    return print_error(s, set.error());
  const double problem_ms = clock.restart();
  const auto device = fem::open_backend(options.solver.device);
  if (!device)
    return print_error(s, device.error());
  const double device_ms = clock.milliseconds();
  const auto result = fem::solve_cases(*set, **device, settings_of(options), make_execution(s));
  if (!result)
    return print_error(s, result.error());
  if (auto written = write_output(options, mesh, *set, *result); !written)
    return print_error(s, written.error());
  auto outcome = make_outcome(mesh, *set, *result, false, 0);
  for (auto& report : outcome.cases)
    report.notice = (*device)->info().notice;
  const solve_times times{import_ms,           result->assembly_ms, result->setup_ms + problem_ms,
                          result->solve_ms,    result->recovery_ms, device_ms,
                          total.milliseconds()};
  print_result(s, to_json(outcome, times), describe(outcome, times));
  return 0;
}

}  // namespace

void add_solve(CLI::App& app, action& chosen) {
  auto options = std::make_shared<solve_options>();
  auto* command = app.add_subcommand("solve", "Solve load cases on a mesh");
  add_part_options(*command, options->part);
  command
    ->add_option("--load-case", options->load_cases,
                 std::string(load_case_help) + ". Several are solved together and get an envelope")
    ->allow_extra_args(false);
  command->add_option(
    "-o,--output", options->output,
    "Write the fields to this file: .vtu, in metres and pascals at the mesh's vertices, or "
    ".frd, as CalculiX writes results, at all nodes that are solved for");
  add_solver_options(*command, options->solver);
  command
    ->add_option(
      "--energy-tolerance", options->energy_tolerance,
      "Stop already when the estimated relative error in energy is below this: a preview")
    ->check(number_in({1e-9, 0.5, {}}));
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_solve(*options, s); }; });
}

}  // namespace tedit::cli
