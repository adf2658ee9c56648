// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_solve MESH LOAD_CASE [--device NAME] [--order N] [--tolerance T] [--repeat N]: solves cold,
// N times, and prints one JSON object: accuracy first, then the median of wall and CPU seconds of
// set-up and solve together (from the problem to the displacement and stresses), and the memory.
#include <algorithm>
#include <ctime>
#include <iostream>

#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "fem/native/native_backend.hpp"
#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace {

using namespace tedit;

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

struct run_figures {
  std::vector<double> wall, cpu;
  fem::solution last;
};

expected<run_figures> measure(const fem::problem& p, fem::backend& device,
                              const fem::solve_settings& settings, int repeats) {
  run_figures result;
  for (int i = 0; i < repeats; ++i) {
    const stopwatch clock;
    const double before = cpu_seconds();
    auto solved = fem::solve(p, device, settings, {});
    if (!solved)
      return fail(solved.error());
    result.wall.push_back(clock.milliseconds() / 1000);
    result.cpu.push_back(cpu_seconds() - before);
    result.last = std::move(*solved);
  }
  return result;
}

nlohmann::json describe(const fem::problem& p, const run_figures& runs) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto& s = runs.last;
  return {{"tets", p.element_count()},
          {"dofs", p.dofs()},
          {"element_order", s.element_order},
          {"device", s.device},
          {"true_relative_residual", s.true_relative_residual},
          {"compliance_j", s.compliance_j},
          {"max_displacement_m", s.max_displacement_m},
          {"iterations", s.iterations},
          {"wall_s", median(runs.wall)},
          {"cpu_s", median(runs.cpu)},
          {"assembly_ms", s.assembly_ms},
          {"setup_ms", s.setup_ms},
          {"solve_ms", s.solve_ms},
          {"recovery_ms", s.recovery_ms},
          {"peak_mib", usage.ru_maxrss / 1024}};
}

}  // namespace

int main(int argc, char** argv) {
  std::string mesh_file;
  std::string load_file;
  std::string device_name = "cpu";
  int order = 1;
  int repeats = 5;
  fem::solve_settings settings;
  CLI::App app("Cold solves with their accuracy, time and memory");
  app.add_option("mesh", mesh_file)->required();
  app.add_option("load_case", load_file)->required();
  app.add_option("--device", device_name);
  app.add_option("--order", order);
  app.add_option("--tolerance", settings.tolerance);
  app.add_option("--repeat", repeats)->check(CLI::Range(1, 100));
  fem::native_settings native;
  app.add_option("--weak-edge", native.multilevel.weak_edge, "Of the native backend");
  app.add_option("--coarsest", native.multilevel.coarsest);
  app.add_option("--degree", native.cycle.node_degree);
  app.add_option("--rigid-degree", native.cycle.rigid_degree);
  app.add_option("--repeats", native.cycle.repeats, "Cycles a visit of a rigid level");
  app.add_option("--quadratic-degree", native.cycle.quadratic_degree);
  app.add_option("--corner-weak-edge", native.corner_multilevel.weak_edge);
  app.add_option("--corner-degree", native.corner_cycle.node_degree);
  app.add_option("--inner-reduction", settings.inner_reduction);
  CLI11_PARSE(app, argc, argv);
  const auto stop = [](const error& e) {
    std::cerr << render(e) << '\n';
    return 1;
  };
  const auto loads = protocol::load_case_from_file(load_file);
  if (!loads)
    return stop(loads.error());
  const auto mesh = import_mesh(std::filesystem::path(mesh_file), "mm");
  if (!mesh)
    return stop(mesh.error());
  auto device = device_name == "cpu"
                  ? expected<std::unique_ptr<fem::backend>>(fem::make_native_backend(native))
                  : fem::open_backend(device_name);
  if (!device)
    return stop(device.error());
  const auto p = fem::make_problem(*mesh->version, *loads, order);
  if (!p)
    return stop(p.error());
  const auto runs = measure(*p, **device, settings, repeats);
  if (!runs)
    return stop(runs.error());
  std::cout << describe(*p, *runs).dump() << '\n';
  return 0;
}
