// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/solver.hpp"

#include <algorithm>
#include <cmath>

#include "base/guard.hpp"
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

constexpr int most_stalled_rounds = 8;

/// Outer iteration in double precision around a backend's inner solves.
class refinement {
public:
  refinement(const problem& p, const element_operator& k, linear_system& system,
             const solve_settings& settings)
      : p_(p), k_(k), system_(system), settings_(settings), residual_(p.dofs()) {}

  expected<void> run(solution& out, const execution& exec, const frame_callback& on_frame) {
    start(out);
    int stalled = 0;
    for (int round = 1; !done(out); ++round) {
      if (round > settings_.max_outer_rounds || stalled > most_stalled_rounds)
        return not_converged(out);
      const double previous = out.true_relative_residual;
      if (auto ok = improve(out, reduction_of(round, out, on_frame != nullptr), exec); !ok)
        return ok;
      if (!(out.true_relative_residual <= 0.7 * previous)) {
        ++stalled;
        system_.distrust();
        if (!(out.true_relative_residual <= previous) && round > 1)
          take_back(out);
      }
      exec.report(progress(out), "solving");
      if (on_frame && !done(out))
        on_frame({round, out.iterations, out.true_relative_residual, out.energy_error,
                  [&] { return guarded([&] { return as_it_is(out); }); }});
    }
    out.converged = out.true_relative_residual <= settings_.tolerance;
    return {};
  }

private:
  [[nodiscard]] bool done(const solution& out) const {
    return out.true_relative_residual <= settings_.tolerance ||
           (settings_.energy_tolerance > 0 && out.energy_error <= settings_.energy_tolerance);
  }

  /// The preconditioned norm that steers the inner loop may lag behind the true one.
  [[nodiscard]] double reduction_of(int round, const solution& out, bool frames) const {
    double wanted = 0.3 * settings_.tolerance / out.true_relative_residual;
    wanted = std::max(wanted, settings_.energy_tolerance / out.energy_error);
    wanted = std::max(wanted, settings_.inner_reduction);
    return frames && round == 1 ? std::max(wanted, settings_.preview_energy) : wanted;
  }

  expected<void> improve(solution& out, double reduction, const execution& exec) {
    correction_.resize(p_.dofs());
    // Single precision works best near one; its own scale is the residual's norm.
    scale_ = norm_of(residual_);
    for (auto& value : residual_)
      value /= scale_;
    const auto inner =
      system_.solve(residual_, correction_, reduction, settings_.max_inner_iterations, exec);
    if (!inner)
      return fail(inner.error());
    out.iterations += inner->iterations;
    if (!inner->broke_down)
      out.energy_error *= std::min(1.0, inner->recurrence_reduction);
    for (std::size_t i = 0; i < correction_.size(); ++i)
      out.displacement[i] += scale_ * correction_[i];
    update(out);
    return {};
  }

  /// Undoes the last correction, which made things worse.
  void take_back(solution& out) {
    for (std::size_t i = 0; i < correction_.size(); ++i)
      out.displacement[i] -= scale_ * correction_[i];
    out.energy_error = 1;
    update(out);
  }

  [[nodiscard]] expected<solution> as_it_is(const solution& out) const {
    solution copy = out;
    if (auto ok = recover(p_, k_, &system_, copy); !ok)
      return fail(ok.error());
    return copy;
  }

  void start(solution& out) {
    out.displacement = p_.prescribed;
    reference_ = residual_norm(out);
    if (!settings_.start.empty())
      add_start(out);
    update(out);
    // A start that is near has a small residual; how near in energy nobody knows yet.
    out.energy_error = std::min(1.0, out.true_relative_residual);
  }

  /// Adds the multiple of the start value whose error has the least energy: alpha = d.r / d.Kd.
  void add_start(solution& out) {
    auto d = settings_.start;
    apply_filter(p_, d);
    std::vector<double> kd(d.size());
    k_.apply(d, kd);
    double work = 0;
    double energy = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      work += d[i] * residual_[i];
      energy += d[i] * kd[i];
    }
    if (!(energy > 0) || !std::isfinite(work))
      return;
    for (std::size_t i = 0; i < d.size(); ++i)
      out.displacement[i] += work / energy * d[i];
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
  linear_system& system_;
  const solve_settings& settings_;
  std::vector<double> residual_;
  std::vector<double> correction_;
  double scale_ = 1;  ///< Of the last correction.
  double reference_ = 0;
};

expected<solution> refine_and_recover(const problem& p, const element_operator& k,
                                      linear_system& system, const std::string& device,
                                      const solve_settings& settings, const execution& run,
                                      const frame_callback& on_frame) {
  if (!(settings.tolerance > 0))
    return fail(ec::invalid_argument, "the tolerance must be a positive number");
  if (!settings.start.empty() && settings.start.size() != p.dofs())
    return fail(ec::invalid_argument, "the start value has the wrong length");
  solution out;
  out.element_order = p.element_order;
  out.device = device;
  run.report(0.1, "solving");
  stopwatch clock;
  refinement outer(p, k, system, settings);
  if (auto ok = outer.run(out, run, on_frame); !ok)
    return fail(ok.error());
  out.solve_ms = clock.restart();
  run.report(0.95, "recovering stresses");
  if (auto ok = recover(p, k, &system, out); !ok)
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
