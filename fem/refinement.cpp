// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "fem/node_values.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

constexpr int most_stalled_rounds = 8;

/// Calls work(n, sums) for every node, on all cores. Returns what the calls added to `sums`, chunk
/// by chunk, so that the bits do not depend on the threads.
template <std::size_t Sums, class Work>
std::array<double, Sums> over_nodes(std::size_t nodes, const Work& work) {
  const auto parts = parts_of_nodes<std::array<double, Sums>>(nodes, work);
  std::array<double, Sums> all{};
  for (const auto& part : parts)
    for (std::size_t i = 0; i < Sums; ++i)
      all[i] += part[i];
  return all;
}

}  // namespace

std::string in_case(const std::string& name, const std::string& message) {
  return name.empty() ? message : "load case '" + name + "': " + message;
}

expected<void> check_settings(const problem& p, const solve_settings& settings) {
  if (!(settings.tolerance > 0))
    return fail(ec::invalid_argument, "the tolerance must be a positive number");
  if (!(settings.energy_tolerance >= 0))
    return fail(ec::invalid_argument, "the energy tolerance must be a number, 0 or more");
  if (!settings.start.empty() && settings.start.size() != p.dofs())
    return fail(ec::invalid_argument, "the start value has the wrong length");
  return {};
}

refinement::refinement(conditions_view conditions, const element_operator& k,
                       const solve_settings& settings, solution& out)
    : conditions_(std::move(conditions)),
      k_(&k),
      settings_(&settings),
      out_(&out),
      residual_(conditions_.loads.size()),
      correction_(conditions_.loads.size()) {
  polled_resize(out.displacement, conditions_.prescribed.size());
  over_nodes<0>(nodes(), [&](std::size_t n, auto&) {
    put(value_at(conditions_.prescribed, n), n, out.displacement);
    put({}, n, correction_);
  });
  reference_ = norm_ = start_residual();
  out.true_relative_residual = reference_ == 0 ? 0 : 1;
  if (!settings.start.empty())
    add_start();
  out.energy_error = out.true_relative_residual > 0 ? 1 : 0;  // Nobody knows yet.
}

expected<void> refinement::check_start() const {
  if (std::isfinite(reference_))
    return {};
  return fail(ec::invalid_load,
              in_case(conditions_.name,
                      "the loads and prescribed displacements add up to no "
                      "finite number"),
              "Check their units, and those of the materials");
}

bool refinement::done() const {
  return out_->true_relative_residual <= settings_->tolerance ||
         (settings_->energy_tolerance > 0 && out_->energy_error <= settings_->energy_tolerance);
}

bool refinement::gave_up() const {
  return round_ >= settings_->max_outer_rounds || stalled_ > most_stalled_rounds;
}

double refinement::progress() const {
  const double reached = std::log(std::max(out_->true_relative_residual, 1e-300));
  return std::clamp(reached / std::log(settings_->tolerance), 0.0, 1.0);
}

inner_case refinement::next(bool early) {
  ++round_;
  const double wanted = settings_->tolerance / out_->true_relative_residual;
  double energy = settings_->energy_tolerance;
  if (early && round_ == 1)
    energy = std::max(energy, settings_->preview_energy);
  // Single precision works best near one; its own scale is the residual's norm.
  scale_ = norm_;
  over_nodes<0>(nodes(),
                [&](std::size_t n, auto&) { put(value_at(residual_, n) / scale_, n, residual_); });
  inner_case inner{.residual = residual_, .correction = correction_};
  // The residual of single precision lags a little behind the true one. Should it stay above, the
  // preconditioned norm says when to look at the true one all the same.
  inner.residual_reduction = 0.8 * wanted;
  inner.reduction = std::max(0.1 * wanted, settings_->inner_reduction);
  // From nothing, what is gained is the energy of the field.
  inner.energy = energy * energy_ / scale_;
  inner.share = energy_ > 0 ? 0 : energy;
  return inner;
}

bool refinement::take(const inner_result& inner) {
  const double previous = out_->true_relative_residual;
  out_->iterations += inner.iterations;
  add_correction(scale_);
  if (!inner.broke_down && energy_ > 0)
    out_->energy_error = std::min(1.0, scale_ * inner.energy / energy_);
  if (out_->true_relative_residual <= 0.7 * previous)
    return true;
  ++stalled_;
  if (!(out_->true_relative_residual <= previous) && round_ > 1) {
    add_correction(-scale_);
    out_->energy_error = 1;
  }
  return false;
}

void refinement::add_correction(double factor) {
  over_nodes<0>(nodes(), [&](std::size_t n, auto&) {
    // Directions that are held stay so to double precision.
    const auto c = filtered(conditions_.filter[n], value_at(correction_, n));
    put(c, n, correction_);
    put(value_at(out_->displacement, n) + factor * c, n, out_->displacement);
  });
  norm_ = residual_norm();
  out_->true_relative_residual = reference_ > 0 ? norm_ / reference_ : 0;
}

/// The residual of the prescribed displacement alone: mostly that is zero, and nothing to multiply.
/// Where supports take the whole load, only the rounding of their directions is left: that is none.
double refinement::start_residual() {
  const auto [moved, squares, applied] = over_nodes<3>(nodes(), [&](std::size_t n, auto& sums) {
    const auto u = value_at(conditions_.prescribed, n);
    const auto f = value_at(conditions_.loads, n);
    const auto r = filtered(conditions_.filter[n], f);
    put(r, n, residual_);
    sums[0] += u == vec3{} ? 0 : 1;
    sums[1] += dot(r, r);
    sums[2] += dot(f, f);
  });
  constexpr double rounding = 2e-12;  // See `roller_directions`.
  if (moved > 0)
    return residual_norm();
  // What is no finite number must not pass for none: `applied` may be infinite, too.
  return squares <= rounding * rounding * applied && std::isfinite(applied) ? 0
                                                                            : std::sqrt(squares);
}

/// Adds the multiple of the start value d whose error has the least energy, alpha = d.r / d.Kd, and
/// carries residual and energy along: with the prescribed displacement g, d.Kg = d.f - d.r.
void refinement::add_start() {
  raw_vector<double> d(settings_->start.size());
  raw_vector<double> kd(d.size());
  over_nodes<0>(nodes(), [&](std::size_t n, auto&) {
    put(filtered(conditions_.filter[n], value_at(settings_->start, n)), n, d);
  });
  k_->apply(d, kd);
  const auto [work, by_loads, energy] = over_nodes<3>(nodes(), [&](std::size_t n, auto& sums) {
    const auto its = value_at(d, n);
    const auto force = filtered(conditions_.filter[n], value_at(kd, n));
    put(force, n, kd);
    sums[0] += dot(its, value_at(residual_, n));
    sums[1] += dot(its, value_at(conditions_.loads, n));
    sums[2] += dot(its, force);
  });
  if (!(energy > 0) || !std::isfinite(work))
    return;
  const double alpha = work / energy;
  const auto [squares] = over_nodes<1>(nodes(), [&](std::size_t n, auto& sums) {
    for (std::size_t i = 3 * n; i < 3 * n + 3; ++i) {
      out_->displacement[i] += alpha * d[i];
      residual_[i] -= alpha * kd[i];
      sums[0] += residual_[i] * residual_[i];
    }
  });
  energy_ = std::sqrt(
    std::max(0.0, energy_ * energy_ + 2 * alpha * (by_loads - work) + alpha * alpha * energy));
  norm_ = std::sqrt(squares);
  out_->true_relative_residual = reference_ > 0 ? norm_ / reference_ : 0;
}

/// Makes the residual that of the displacement, and `energy_`, too.
double refinement::residual_norm() {
  k_->apply(out_->displacement, residual_);
  const auto [strain, squares] = over_nodes<2>(nodes(), [&](std::size_t n, auto& sums) {
    const auto f = value_at(conditions_.loads, n);
    const auto ku = value_at(residual_, n);
    const auto r = filtered(conditions_.filter[n], f - ku);
    put(r, n, residual_);
    sums[0] += dot(ku, value_at(out_->displacement, n));
    sums[1] += dot(r, r);
  });
  energy_ = std::sqrt(std::max(0.0, strain));
  return std::sqrt(squares);
}

tl::unexpected<error> refinement::not_converged() const {
  char text[160];
  std::snprintf(
    text, sizeof(text),
    "the solver stopped at a relative residual of %.2g after %d iterations; %.2g was asked for",
    out_->true_relative_residual, out_->iterations, settings_->tolerance);
  return fail(ec::not_converged, in_case(conditions_.name, text),
              "Check for very thin tets (tedit info), or ask for a larger tolerance");
}

expected<void> refine(std::span<refinement> cases, linear_system& system,
                      const solve_settings& settings, const execution& run,
                      const std::function<void(int round)>& on_round) {
  for (const auto& c : cases)
    if (auto ok = c.check_start(); !ok)
      return ok;
  for (int round = 1;; ++round) {
    std::vector<refinement*> open;
    std::vector<inner_case> inner;
    for (auto& c : cases)
      if (!c.done()) {
        if (c.gave_up())
          return c.not_converged();
        open.push_back(&c);
        inner.push_back(c.next(on_round != nullptr));
      }
    if (open.empty())
      return {};
    const auto results = system.solve_many(inner, settings.max_inner_iterations, run);
    if (!results)
      return fail(results.error());
    bool worth_while = true;
    for (std::size_t i = 0; i < open.size(); ++i)
      worth_while = open[i]->take((*results)[i]) && worth_while;
    if (!worth_while)
      system.distrust();
    double progress = 1;
    for (const auto& c : cases)
      progress = std::min(progress, c.progress());
    run.report(0.1 + 0.8 * progress, "solving");
    if (on_round && !std::ranges::all_of(cases, &refinement::done))
      on_round(round);
  }
}

}  // namespace tedit::fem
