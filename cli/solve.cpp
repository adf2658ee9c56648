// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/field_file.hpp"
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
};

struct solve_times {
  double import_ms = 0;
  double problem_ms = 0;
  double total_ms = 0;
};

nlohmann::ordered_json to_json(const mesh_version& mesh, const fem::problem& problem,
                               const fem::solution& result, const solve_times& times) {
  const auto triple = [](vec3 v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
  return {{"version_id", to_hex(mesh.id())},
          {"device", result.device},
          {"element_order", result.element_order},
          {"preview", result.preview()},
          {"dofs", problem.dofs()},
          {"iterations", result.iterations},
          {"true_relative_residual", result.true_relative_residual},
          {"max_displacement_m", result.max_displacement_m},
          {"max_displacement_at_m", triple(result.max_displacement_at)},
          {"compliance_j", result.compliance_j},
          {"max_von_mises_pa", result.max_von_mises_pa},
          {"max_von_mises_at_m", triple(result.max_von_mises_at)},
          {"reaction_n", triple(result.reaction_n)},
          {"applied_n", triple(result.applied_n)},
          {"timings_ms",
           {{"import", times.import_ms},
            {"assembly", result.assembly_ms},
            {"setup", times.problem_ms + result.setup_ms},
            {"solve", result.solve_ms},
            {"recovery", result.recovery_ms},
            {"total", times.total_ms}}}};
}

std::string describe(const fem::problem& problem, const fem::solution& result,
                     const solve_times& times) {
  const auto mm = [](vec3 p) {
    return "(" + pretty(1e3 * p.x) + ", " + pretty(1e3 * p.y) + ", " + pretty(1e3 * p.z) + ") mm";
  };
  std::string text;
  const auto line = [&](const std::string& label, const std::string& value) {
    text += "  " + label + std::string(18 - label.size(), ' ') + value + "\n";
  };
  line("device", result.device);
  line("unknowns", std::to_string(problem.dofs()) + " (linear tets)");
  line("iterations", std::to_string(result.iterations));
  line("residual", pretty(result.true_relative_residual, 2) + " (true, relative)");
  line("max displacement",
       pretty(1e3 * result.max_displacement_m, 6) + " mm at " + mm(result.max_displacement_at));
  line("max von Mises",
       pretty(1e-6 * result.max_von_mises_pa, 5) + " MPa at " + mm(result.max_von_mises_at));
  line("compliance", pretty(result.compliance_j, 6) + " J");
  const auto& r = result.reaction_n;
  const auto& a = result.applied_n;
  line("reaction", pretty(r.x, 6) + ", " + pretty(r.y, 6) + ", " + pretty(r.z, 6) + " N");
  line("applied", pretty(a.x, 6) + ", " + pretty(a.y, 6) + ", " + pretty(a.z, 6) + " N");
  line("time", pretty(times.total_ms) + " ms (import " + pretty(times.import_ms, 3) +
                 ", assembly " + pretty(result.assembly_ms, 3) + ", solve " +
                 pretty(result.solve_ms, 4) + ", recovery " + pretty(result.recovery_ms, 3) + ")");
  if (result.preview())
    text +=
      "  PREVIEW: linear tets are too stiff in bending; displacements of thin parts can be\n"
      "  several times too small.\n";
  return text;
}

int run_solve(const solve_options& options, session& s) {
  const stopwatch total;
  stopwatch clock;
  solve_times times;
  const auto loads = protocol::load_case_from_file(options.load_case);
  if (!loads)
    return print_error(s, loads.error());
  const auto imported = import_mesh(options.mesh, options.length_unit);
  if (!imported)
    return print_error(s, imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  const auto& mesh = *imported->version;
  times.import_ms = clock.restart();

  const auto problem = fem::make_problem(mesh, *loads);
  if (!problem)
    return print_error(s, problem.error());
  times.problem_ms = clock.restart();
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
  times.total_ms = total.milliseconds();
  print_result(s, to_json(mesh, *problem, *result, times), describe(*problem, *result, times));
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
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_solve(*options, s); }; });
}

}  // namespace tedit::cli
