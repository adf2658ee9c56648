// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_solve MESH LOAD_CASE [--device NAME] [--order N] [--tolerance T] [--repeat N] [--cases N]
// [--cancel-sweep N] [--write-system FILE]: solves cold, several times, and prints one JSON object:
// accuracy first, then the median of wall and CPU seconds of set-up, solve and recovery together
// (from the problem to the displacement and stresses), the CPU seconds of the assembly (native),
// before the solve and before the recovery, and the memory: before all that, and at its peak. With
// --cases, the file's loads turned and weighted in N ways are solved together. With --cancel-sweep,
// N solves are cancelled at moments spread over a whole one, and how long each takes to come back
// is printed (bench/cancel_sweep.hpp). With --write-system nothing is solved: the equations go to a
// file that other solvers read (bench/peers/system.hpp).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>

#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/memory.hpp"
#include "base/stopwatch.hpp"
#include "bench/cancel_sweep.hpp"
#include "bench/peers/system.hpp"
#include "fem/load_cases.hpp"
#include "fem/native/backend.hpp"
#include "fem/solver.hpp"
#include "fem/vulkan/backend.hpp"
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

/// What the process holds now.
long resident_mib() {
  long all = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE) / (1 << 20);
}

long peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

expected<std::unique_ptr<fem::backend>> open_device(const std::string& name,
                                                    const fem::native_settings& native) {
  if (name == "cpu")
    return fem::make_native_backend(native);
  if (name == "auto")
    return fem::open_backend(name);
  fem::vulkan_settings settings;
  settings.multilevel.rounded = native.multilevel.rounded;
  return fem::open_vulkan(name, settings);
}

/// Another load for each case: its components exchanged, and by and by more uneven along x.
fem::case_set make_set(fem::problem p, int count) {
  fem::case_set set;
  for (int c = 0; c < count; ++c) {
    fem::conditions one{
      "case " + std::to_string(c), {}, p.loads, p.filter, p.prescribed, p.holders};
    const int uneven = c / 3;
    for (std::size_t n = 0; n < p.node_count(); ++n)
      for (std::size_t i = 0; i < 3; ++i)
        one.loads[3 * n + i] = p.loads[3 * n + (i + static_cast<std::size_t>(c)) % 3] *
                               (1 + uneven * std::cos(100 * p.nodes[n].x));
    set.cases.push_back(std::move(one));
  }
  set.problem = std::move(p);
  return set;
}

struct run_figures {
  std::vector<double> wall, cpu, cpu_assembly, cpu_setup, cpu_before_recovery;
  long before_mib = 0;
  fem::solution last;
};

expected<run_figures> measure(fem::case_set& set, fem::backend& device,
                              const fem::solve_settings& settings, int repeats) {
  run_figures result;
  result.before_mib = resident_mib();
  for (int i = 0; i < repeats; ++i) {
    const stopwatch clock;
    const double before = cpu_seconds();
    double assembled_at = before;
    double ready_at = 0;
    double solved_at = 0;
    execution run;
    run.progress = [&](double, std::string_view stage) {
      if (stage == "preparing the preconditioner")
        assembled_at = cpu_seconds();
      if (stage == "solving" && ready_at == 0)
        ready_at = cpu_seconds();
      if (stage == "recovering stresses")
        solved_at = cpu_seconds();
    };
    if (set.cases.size() == 1) {
      auto solved = fem::solve(set.problem, device, settings, run);
      if (!solved)
        return fail(solved.error());
      result.last = std::move(*solved);
    } else {
      auto solved = fem::solve_cases(set, device, settings, run);
      if (!solved)
        return fail(solved.error());
      result.last = std::move(solved->cases.back());
    }
    result.wall.push_back(clock.milliseconds() / 1000);
    result.cpu.push_back(cpu_seconds() - before);
    result.cpu_assembly.push_back(assembled_at - before);
    result.cpu_setup.push_back(ready_at - before);
    result.cpu_before_recovery.push_back(solved_at - before);
  }
  return result;
}

nlohmann::json describe(const fem::problem& p, const run_figures& runs) {
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
          {"cpu_assembly_s", median(runs.cpu_assembly)},
          {"cpu_setup_s", median(runs.cpu_setup)},
          {"cpu_before_recovery_s", median(runs.cpu_before_recovery)},
          {"assembly_ms", s.assembly_ms},
          {"setup_ms", s.setup_ms},
          {"solve_ms", s.solve_ms},
          {"recovery_ms", s.recovery_ms},
          {"before_mib", runs.before_mib},
          {"peak_mib", peak_mib()}};
}

int write_equations(const fem::problem& p, const std::string& file) {
  const auto written = bench::write_system(p, file);
  if (!written) {
    std::cerr << render(written.error()) << '\n';
    return exit_status(written.error().code);
  }
  const nlohmann::json result{{"file", file},
                              {"tets", written->tets},
                              {"element_order", written->element_order},
                              {"unknowns", 3 * written->nodes},
                              {"blocks", written->blocks}};
  std::cout << result.dump() << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  return_large_blocks();
  std::string mesh_file;
  std::string load_file;
  std::string system_file;
  std::string device_name = "cpu";
  int order = 1;
  int repeats = 5;
  int cases = 1;
  fem::solve_settings settings;
  CLI::App app("Cold solves with their accuracy, time and memory");
  app.add_option("mesh", mesh_file)->required();
  app.add_option("load_case", load_file)->required();
  app.add_option("--device", device_name);
  app.add_option("--order", order);
  app.add_option("--tolerance", settings.tolerance);
  app.add_option("--repeat", repeats)->check(CLI::Range(1, 100));
  app.add_option("--cases", cases, "Load cases at once")->check(CLI::Range(1, 100));
  int moments = 0;
  app.add_option("--cancel-sweep", moments, "Cancel so many solves")->check(CLI::Range(1, 10000));
  app.add_option("--write-system", system_file, "Write the equations here, solve nothing");
  fem::native_settings native;
  app.add_option("--weak-edge", native.multilevel.weak_edge, "Of the native backend");
  app.add_option("--coarsest", native.multilevel.coarsest);
  app.add_option("--rounded", native.multilevel.rounded, "Smoothers read rounded values; 1 or 0");
  app.add_option("--degree", native.cycle.node_degree);
  app.add_option("--rigid-degree", native.cycle.rigid_degree);
  app.add_option("--repeats", native.cycle.repeats, "Visits from a rigid level to the next");
  app.add_option("--quadratic-degree", native.cycle.quadratic_degree);
  app.add_option("--corner-weak-edge", native.corner_multilevel.weak_edge);
  app.add_option("--corner-degree", native.corner_cycle.node_degree);
  app.add_option("--over-correction", native.cycle.over_correction);
  app.add_option("--inner-reduction", settings.inner_reduction);
  CLI11_PARSE(app, argc, argv);
  native.corner_multilevel.rounded = native.multilevel.rounded;
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
  auto p = fem::make_problem(*mesh->version, *loads, order);
  if (!p)
    return stop(p.error());
  if (!system_file.empty())
    return write_equations(*p, system_file);
  auto device = open_device(device_name, native);
  if (!device)
    return stop(device.error());
  if (moments > 0) {
    const auto swept =
      bench::cancel_sweep({*mesh->version, *loads, order, **device, settings}, moments);
    if (!swept)
      return stop(swept.error());
    std::cout << swept->dump() << '\n';
    return 0;
  }
  auto set = make_set(std::move(*p), cases);
  const auto runs = measure(set, **device, settings, repeats);
  if (!runs)
    return stop(runs.error());
  std::cout << describe(set.problem, *runs).dump() << '\n';
  return 0;
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
