// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_edit MESH LOAD_CASE --fill IDS... [--order N] [--device NAME] [--energy E] [--repeat N]:
// solves a part, fills a hole and solves again on the kept system, then changes the load and solves
// once more. Prints one JSON object: accuracy against a cold solve of the edited part first, then
// milliseconds of each stage (medians), CPU time and the bytes that went to the device.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <numeric>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/memory.hpp"
#include "base/stopwatch.hpp"
#include "edit/make_edit.hpp"
#include "fem/fields.hpp"
#include "fem/solve_session.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace {

using namespace tedit;
using json = nlohmann::json;

struct options {
  std::string mesh_file, load_file;
  std::string device = "cpu";
  std::vector<surface_id> surfaces;
  int order = 2;
  int repeats = 5;
  double energy = 1e-3;
};

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// Rows of numbers by name; printed as medians.
class series {
public:
  void add(const std::string& name, double value) { values_[name].push_back(value); }

  [[nodiscard]] json medians() const {
    json result = json::object();
    for (auto [name, values] : values_) {
      std::ranges::sort(values);
      result[name] = values[values.size() / 2];
    }
    return result;
  }

private:
  std::map<std::string, std::vector<double>> values_;
};

/// Hands work to another backend and keeps an eye on the last system, which a session owns.
class watched_backend final : public fem::backend {
public:
  explicit watched_backend(fem::backend& behind) : behind_(behind) {}

  const fem::device_info& info() const override { return behind_.info(); }
  expected<std::unique_ptr<fem::linear_system>> assemble(const fem::problem& p,
                                                         const execution& run) override {
    auto made = behind_.assemble(p, run);
    last_ = made ? made->get() : nullptr;
    return made;
  }
  /// Of the last system; only while its session lives.
  [[nodiscard]] double uploaded_bytes() const {
    return last_ ? static_cast<double>(last_->uploaded_bytes()) : 0;
  }

private:
  fem::backend& behind_;
  fem::linear_system* last_ = nullptr;
};

/// Of an early field against the final one: relative, in the energy norm.
double energy_error(const fem::problem& p, const fem::solution& early, const fem::solution& last) {
  auto d = early.displacement;
  for (std::size_t i = 0; i < d.size(); ++i)
    d[i] -= last.displacement[i];
  std::vector<double> kd(d.size());
  fem::element_operator(p).apply(d, kd);
  return std::sqrt(std::inner_product(d.begin(), d.end(), kd.begin(), 0.0) /
                   (2 * last.strain_energy_j));
}

/// One solve of a session with what it cost, until the first frame and until the end.
expected<fem::solution> timed_solve(fem::solve_session& session, const version_ptr& mesh,
                                    const fem::load_case& loads, const options& o,
                                    fem::backend& device, series& times) {
  fem::solve_settings settings;
  settings.preview_energy = o.energy;
  const stopwatch clock;
  const double before = cpu_ms();
  double first = 0;
  fem::solution seen;
  const auto on_frame = [&](const fem::solve_frame& frame) {
    if (first > 0)
      return;
    if (auto now = frame.recover())
      seen = std::move(*now);
    first = clock.milliseconds();
  };
  auto result = session.solve(mesh, loads, o.order, device, settings, {}, on_frame);
  if (!result)
    return fail(result.error());
  const auto& s = result->solution;
  times.add("total_ms", clock.milliseconds());
  times.add("total_cpu_ms", cpu_ms() - before);
  times.add("first_field_ms", first > 0 ? first : clock.milliseconds());
  times.add("first_field_iterations", seen.iterations);
  times.add("first_field_estimated_error", seen.energy_error);
  times.add("first_field_error", first > 0 ? energy_error(session.last_problem(), seen, s) : 0);
  times.add("setup_ms", s.setup_ms);
  times.add("assembly_ms", s.assembly_ms);
  times.add("solve_ms", s.solve_ms);
  times.add("recovery_ms", s.recovery_ms);
  times.add("iterations", s.iterations);
  times.add("assembled", result->assembled ? 1 : 0);
  const stopwatch making;
  const auto fields = fem::make_fields(*mesh, session.last_problem(), s);
  times.add("fields_ms", fields.empty() ? 0 : making.milliseconds());
  return std::move(result->solution);
}

double worst_difference(const fem::problem& p, const fem::solution& a, const fem::problem& q,
                        const fem::solution& b) {
  const auto other = fem::carry_over(q, b.displacement, p);
  double worst = 0;
  for (std::size_t i = 0; i < 3 * p.corner_count; ++i)
    worst = std::max(worst, std::abs(a.displacement[i] - other[i]));
  return worst / b.max_displacement_m;
}

fem::load_case turned(fem::load_case loads) {
  for (auto& item : loads.loads)
    if (auto* f = std::get_if<fem::force>(&item.kind))
      f->total_n = {f->total_n.y, f->total_n.z, f->total_n.x};
    else if (auto* p = std::get_if<fem::pressure>(&item.kind))
      p->pa *= -0.7;
  return loads;
}

struct figures {
  series edit, cold, after_edit, after_load;
  double difference = 0;
  double residual = 0;
  std::size_t tets = 0, unknowns = 0;
};

expected<void> measure(const version_ptr& base, const fem::load_case& loads,
                       const ops::catalogue& plugins, fem::backend& on, const options& o,
                       figures& out) {
  watched_backend device(on);
  fem::solve_session session;
  if (auto ok = timed_solve(session, base, loads, o, device, out.cold); !ok)
    return fail(ok.error());
  out.cold.add("uploaded_bytes", device.uploaded_bytes());
  const stopwatch clock;
  const auto edited = make_edit(plugins, base, {"fill_hole", o.surfaces, {}, {}}, {loads}, {}, {});
  if (!edited)
    return fail(edited.error());
  out.edit.add("total_ms", clock.milliseconds());
  out.edit.add("operation_ms", edited->report.operation_ms);
  out.edit.add("improve_ms", edited->report.improve_ms);
  out.edit.add("check_ms", edited->report.check_ms);
  const auto& after = edited->load_cases.front();
  const auto again = timed_solve(session, edited->version, after, o, device, out.after_edit);
  if (!again)
    return fail(again.error());
  out.after_edit.add("uploaded_bytes", device.uploaded_bytes());
  out.residual = again->true_relative_residual;
  fem::solve_session fresh;
  series unused;
  const auto cold = timed_solve(fresh, edited->version, after, o, on, unused);
  if (!cold)
    return fail(cold.error());
  out.difference = worst_difference(session.last_problem(), *again, fresh.last_problem(), *cold);
  out.tets = edited->version->tet_count();
  out.unknowns = session.last_problem().dofs();
  if (auto ok = timed_solve(session, edited->version, turned(after), o, device, out.after_load);
      !ok)
    return fail(ok.error());
  return {};
}

}  // namespace

int main(int argc, char** argv) try {
  return_large_blocks();
  options o;
  CLI::App app("From an edit to the new field, against a cold solve");
  app.add_option("mesh", o.mesh_file)->required();
  app.add_option("load_case", o.load_file)->required();
  app.add_option("--fill", o.surfaces, "The walls of the hole")->required();
  app.add_option("--device", o.device);
  app.add_option("--order", o.order);
  app.add_option("--energy", o.energy, "Where the first field is taken");
  app.add_option("--repeat", o.repeats)->check(CLI::Range(1, 100));
  CLI11_PARSE(app, argc, argv);
  const auto stop = [](const error& e) {
    std::cerr << render(e) << '\n';
    return 1;
  };
  const auto loads = protocol::load_case_from_file(o.load_file);
  if (!loads)
    return stop(loads.error());
  const auto mesh = import_mesh(std::filesystem::path(o.mesh_file), "mm");
  if (!mesh)
    return stop(mesh.error());
  const auto device = fem::open_backend(o.device);
  if (!device)
    return stop(device.error());
  const auto plugins = ops::load_default_catalogue();
  figures f;
  for (int i = 0; i < o.repeats; ++i)
    if (auto ok = measure(mesh->version, *loads, plugins, **device, o, f); !ok)
      return stop(ok.error());
  std::cout << json{{"tets", f.tets},
                    {"unknowns", f.unknowns},
                    {"element_order", o.order},
                    {"device", (*device)->info().name},
                    {"difference_to_cold", f.difference},
                    {"true_relative_residual", f.residual},
                    {"edit", f.edit.medians()},
                    {"cold", f.cold.medians()},
                    {"after_edit", f.after_edit.medians()},
                    {"after_load", f.after_load.medians()}}
                 .dump(1)
            << '\n';
  return 0;
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
