// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/solver.hpp"

#include "base/guard.hpp"
#include "base/stopwatch.hpp"
#include "fem/recovery.hpp"
#include "fem/refinement.hpp"

namespace tedit::fem {

namespace {

expected<solution> refine_and_recover(const problem& p, const element_operator& k,
                                      linear_system& system, const std::string& device,
                                      const solve_settings& settings, const execution& run,
                                      const frame_callback& on_frame) {
  if (auto ok = check_settings(p, settings); !ok)
    return fail(ok.error());
  solution out;
  out.element_order = p.element_order;
  out.device = device;
  run.report(0.1, "solving");
  const auto as_it_is = [&]() -> expected<solution> {
    solution copy = out;
    if (auto ok = recover(p, k, copy); !ok)
      return fail(ok.error());
    return copy;
  };
  std::function<void(int)> on_round;
  if (on_frame)
    on_round = [&](int round) {
      on_frame({round, out.iterations, out.true_relative_residual, out.energy_error,
                [&] { return guarded(as_it_is); }});
    };
  stopwatch clock;
  refinement outer({"", p.loads, p.filter, p.prescribed}, k, settings, out);
  if (auto ok = refine({&outer, 1}, system, settings, run, on_round); !ok)
    return fail(ok.error());
  out.converged = out.true_relative_residual <= settings.tolerance;
  out.solve_ms = clock.restart();
  run.report(0.95, "recovering stresses");
  if (auto ok = recover(p, k, out); !ok)
    return fail(ok.error());
  out.recovery_ms = clock.restart();
  run.report(1, "done");
  return out;
}

expected<solution> assemble_and_solve(const problem& p, backend& device,
                                      const solve_settings& settings, const execution& run,
                                      const frame_callback& on_frame) {
  run.report(0.02, "assembling");
  stopwatch clock;
  auto system = device.assemble(p, run);
  if (!system)
    return fail(system.error());
  const double assembly_ms = clock.restart();
  const element_operator k(p);
  const double setup_ms = clock.restart();
  auto result = refine_and_recover(p, k, **system, device.info().name, settings, run, on_frame);
  if (result) {
    result->assembly_ms = assembly_ms;
    result->setup_ms = setup_ms;
  }
  return result;
}

}  // namespace

expected<solution> solve(const problem& p, backend& device, const solve_settings& settings,
                         const execution& run, const frame_callback& on_frame) {
  return guarded(run, [&] { return assemble_and_solve(p, device, settings, run, on_frame); });
}

expected<solution> solve(const problem& p, const element_operator& k, linear_system& system,
                         const std::string& device, const solve_settings& settings,
                         const execution& run, const frame_callback& on_frame) {
  return guarded(run,
                 [&] { return refine_and_recover(p, k, system, device, settings, run, on_frame); });
}

void residual(const problem& p, std::span<const double> displacement, std::span<double> result) {
  element_operator(p).apply(displacement, result);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = p.loads[i] - result[i];
}

}  // namespace tedit::fem
