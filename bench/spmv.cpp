// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_spmv MESH LOAD_CASE [--order N] [--device NAME] [--cores N] [--copy-mb N] [--rounded]
// [--repeat N]: the share of the bandwidth of a copy that one product y = K x has. Product and copy
// take turns; prints one JSON object with the medians.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>

#include <sched.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "bench/spmv.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace {

using namespace tedit;

/// A turn takes at least so long, so that clocks and submissions do not count.
constexpr double least_turn_ms = 50;

/// Leaves the process its first `count` cores (0: all), before any thread is started; returns how
/// many it has. The pool's threads take turns where there are more of them than cores.
int keep_cores(int count) {
  cpu_set_t all;
  CPU_ZERO(&all);
  sched_getaffinity(0, sizeof(all), &all);
  if (count == 0)
    return CPU_COUNT(&all);
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &all) && count-- <= 0)
      CPU_CLR(core, &all);
  sched_setaffinity(0, sizeof(all), &all);
  return CPU_COUNT(&all);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// Milliseconds of one of `times` calls in a row.
template <class Call>
expected<double> time_of(const Call& call, int times) {
  const stopwatch clock;
  if (auto ok = call(times); !ok)
    return fail(ok.error());
  return clock.milliseconds() / times;
}

/// How often a call is repeated in a turn, by the second of two trials.
template <class Call>
expected<int> times_of(const Call& call) {
  if (auto warm = time_of(call, 1); !warm)
    return fail(warm.error());
  const auto one = time_of(call, 1);
  if (!one)
    return fail(one.error());
  return std::clamp(static_cast<int>(least_turn_ms / std::max(*one, 1e-3)), 1, 10000);
}

struct turns {
  std::vector<double> product_ms, copy_ms, share;
};

expected<turns> measure(bench::product_probe& probe, int repeats) {
  const auto multiply = [&](int times) { return probe.multiply(times); };
  const auto copy = [&](int times) { return probe.copy(times); };
  const auto products = times_of(multiply);
  const auto copies = times_of(copy);
  if (!products || !copies)
    return fail(products ? copies.error() : products.error());
  turns result;
  for (int i = 0; i < repeats; ++i) {
    const auto product_ms = time_of(multiply, *products);
    const auto copy_ms = time_of(copy, *copies);
    if (!product_ms || !copy_ms)
      return fail(product_ms ? copy_ms.error() : product_ms.error());
    result.product_ms.push_back(*product_ms);
    result.copy_ms.push_back(*copy_ms);
    result.share.push_back(probe.product_bytes() / *product_ms / (probe.copy_bytes() / *copy_ms));
  }
  return result;
}

nlohmann::json describe(const fem::problem& p, const std::string& device, int cores,
                        const bench::product_probe& probe, const turns& t) {
  constexpr double mega = 1e6;  // bytes a millisecond, divided by it, are GB a second
  return {{"device", device},
          {"cores", cores},
          {"tets", p.element_count()},
          {"element_order", p.element_order},
          {"unknowns", p.dofs()},
          {"product_bytes_per_tet", probe.product_bytes() / static_cast<double>(p.element_count())},
          {"product_ms", median(t.product_ms)},
          {"product_gb_s", probe.product_bytes() / median(t.product_ms) / mega},
          {"copy_mb", probe.copy_bytes() / mega},
          {"copy_gb_s", probe.copy_bytes() / median(t.copy_ms) / mega},
          {"share_of_copy", median(t.share)}};
}

}  // namespace

int main(int argc, char** argv) try {
  std::string mesh_file;
  std::string load_file;
  std::string device = "cpu";
  int order = 1;
  int cores = 0;
  int repeats = 15;
  std::uint64_t copy_mb = 0;
  bool rounded = false;
  CLI::App app("The share of the bandwidth of a copy that one product with the matrix has");
  app.add_option("mesh", mesh_file)->required();
  app.add_option("load_case", load_file)->required();
  app.add_option("--device", device, "cpu, lavapipe or part of a device's name");
  app.add_option("--order", order)->check(CLI::IsMember({1, 2}));
  app.add_option("--cores", cores, "Cores to keep; 0: all")->check(CLI::Range(0, 1024));
  app.add_option("--copy-mb", copy_mb, "Bytes of a copy, 10^6; 0: as many as a product moves")
    ->check(CLI::Range(0, 100000));
  app.add_flag("--rounded", rounded, "The values as smoothers read them (cpu, order 1)");
  app.add_option("--repeat", repeats, "Turns of product and copy")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  cores = keep_cores(cores);
  const auto stop = [](const error& e) {
    std::cerr << render(e) << '\n';
    return exit_status(e.code);
  };
  const auto loads = protocol::load_case_from_file(load_file);
  if (!loads)
    return stop(loads.error());
  const auto mesh = import_mesh(std::filesystem::path(mesh_file), "mm");
  if (!mesh)
    return stop(mesh.error());
  const auto p = fem::make_problem(*mesh->version, *loads, order);
  if (!p)
    return stop(p.error());
  auto probe = device == "cpu" ? expected<std::unique_ptr<bench::product_probe>>(
                                   bench::probe_native(*p, 1000000 * copy_mb, rounded))
                               : bench::probe_vulkan(device, *p, 1000000 * copy_mb);
  if (!probe)
    return stop(probe.error());
  const auto measured = measure(**probe, repeats);
  if (!measured)
    return stop(measured.error());
  std::cout << describe(*p, device, cores, **probe, *measured).dump() << '\n';
  return 0;
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
