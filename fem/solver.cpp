// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/solver.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "fem/recovery.hpp"

namespace tedit::fem {

namespace {

double norm_of(std::span<const double> x) {
  return std::sqrt(parallel_sum(x.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i)
      sum += x[i] * x[i];
    return sum;
  }));
}

void apply_filter(const problem& p, std::span<double> x) {
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto& s = p.filter[n];
    double* v = &x[3 * n];
    const std::array<double, 3> y{s[0] * v[0] + s[1] * v[1] + s[2] * v[2],
                                  s[1] * v[0] + s[3] * v[1] + s[4] * v[2],
                                  s[2] * v[0] + s[4] * v[1] + s[5] * v[2]};
    std::ranges::copy(y, v);
  }
}

/// Outer iteration in double precision around a backend's inner solves.
class refinement {
public:
  refinement(const problem& p, const element_operator& k, const solve_settings& settings)
      : p_(p), k_(k), settings_(settings), residual_(p.dofs()) {}

  expected<void> run(linear_system& system, bool double_precision, solution& out,
                     const execution& exec,
                     const std::function<void(const solve_frame&)>& on_frame) {
    start(out);
    std::vector<double> correction(p_.dofs());
    double previous = out.true_relative_residual;
    int stalled = 0;
    for (int round = 1; out.true_relative_residual > settings_.tolerance; ++round) {
      if (round > settings_.max_outer_rounds || stalled > 2)
        return not_converged(out);
      // The preconditioned norm that steers the inner loop may lag behind the true one.
      const double wanted = 0.3 * settings_.tolerance / out.true_relative_residual;
      const double reduction =
        double_precision ? wanted : std::max(wanted, settings_.inner_reduction);
      // Single precision works best near one; its own scale is the residual's norm.
      const double scale = norm_of(residual_);
      for (auto& value : residual_)
        value /= scale;
      const auto inner =
        system.solve(residual_, correction, reduction, settings_.max_inner_iterations, exec);
      if (!inner)
        return fail(inner.error());
      out.iterations += inner->iterations;
      for (std::size_t i = 0; i < correction.size(); ++i)
        out.displacement[i] += scale * correction[i];
      update(out);
      if (!std::isfinite(out.true_relative_residual))
        return not_converged(out);
      stalled = out.true_relative_residual > 0.7 * previous ? stalled + 1 : 0;
      previous = out.true_relative_residual;
      exec.report(progress(out), "solving");
      if (on_frame)
        on_frame({round, out.iterations, out.true_relative_residual});
    }
    return {};
  }

private:
  void start(solution& out) {
    out.displacement = p_.prescribed;
    reference_ = residual_norm(out);
    if (!settings_.start.empty()) {
      auto free = settings_.start;
      apply_filter(p_, free);
      for (std::size_t i = 0; i < free.size(); ++i)
        out.displacement[i] += free[i];
    }
    update(out);
  }

  double residual_norm(const solution& out) {
    k_.apply(out.displacement, residual_);
    for (std::size_t i = 0; i < residual_.size(); ++i)
      residual_[i] = p_.loads[i] - residual_[i];
    apply_filter(p_, residual_);
    return norm_of(residual_);
  }

  void update(solution& out) {
    const double now = residual_norm(out);
    out.true_relative_residual = reference_ > 0 ? now / reference_ : 0;
  }

  [[nodiscard]] double progress(const solution& out) const {
    const double done =
      std::log(std::max(out.true_relative_residual, 1e-300)) / std::log(settings_.tolerance);
    return 0.1 + 0.8 * std::clamp(done, 0.0, 1.0);
  }

  [[nodiscard]] tl::unexpected<error> not_converged(const solution& out) const {
    char text[160];
    std::snprintf(
      text, sizeof(text),
      "the solver stopped at a relative residual of %.2g after %d iterations; %.2g was asked for",
      out.true_relative_residual, out.iterations, settings_.tolerance);
    return fail(ec::not_converged, text,
                "Check for very thin tets (tedit info), or ask for a larger tolerance");
  }

  const problem& p_;
  const element_operator& k_;
  const solve_settings& settings_;
  std::vector<double> residual_;
  double reference_ = 0;
};

}  // namespace

expected<solution> solve(const problem& p, backend& device, const solve_settings& settings,
                         const execution& run,
                         const std::function<void(const solve_frame&)>& on_frame) {
  if (!(settings.tolerance > 0))
    return fail(ec::invalid_argument, "the tolerance must be a positive number");
  if (!settings.start.empty() && settings.start.size() != p.dofs())
    return fail(ec::invalid_argument, "the start value has the wrong length");
  solution out;
  out.element_order = p.element_order;
  out.device = device.info().name;
  run.report(0.02, "assembling");
  stopwatch clock;
  auto system = device.assemble(p, run);
  if (!system)
    return fail(system.error());
  out.assembly_ms = clock.restart();
  const element_operator k(p);
  out.setup_ms = clock.restart();
  run.report(0.1, "solving");
  refinement outer(p, k, settings);
  if (auto ok = outer.run(**system, device.info().double_precision, out, run, on_frame); !ok)
    return fail(ok.error());
  out.solve_ms = clock.restart();
  run.report(0.95, "recovering stresses");
  if (auto ok = recover(p, k, system->get(), out); !ok)
    return fail(ok.error());
  out.recovery_ms = clock.restart();
  run.report(1, "done");
  return out;
}

void residual(const problem& p, std::span<const double> displacement, std::span<double> result) {
  element_operator(p).apply(displacement, result);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = p.loads[i] - result[i];
}

}  // namespace tedit::fem
