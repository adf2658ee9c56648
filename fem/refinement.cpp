// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

constexpr int most_stalled_rounds = 8;

double norm_of(std::span<const double> x) {
  return std::sqrt(parallel_sum(x.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i)
      sum += x[i] * x[i];
    return sum;
  }));
}

void apply_filter(std::span<const std::array<double, 6>> filter, std::span<double> x) {
  polled_for(filter.size(), [&](std::size_t n) {
    const auto& s = filter[n];
    double* v = &x[3 * n];
    const std::array<double, 3> y{s[0] * v[0] + s[1] * v[1] + s[2] * v[2],
                                  s[1] * v[0] + s[3] * v[1] + s[4] * v[2],
                                  s[2] * v[0] + s[4] * v[1] + s[5] * v[2]};
    std::ranges::copy(y, v);
  });
}

}  // namespace

std::string in_case(const std::string& name, const std::string& message) {
  return name.empty() ? message : "load case '" + name + "': " + message;
}

expected<void> check_settings(const problem& p, const solve_settings& settings) {
  if (!(settings.tolerance > 0))
    return fail(ec::invalid_argument, "the tolerance must be a positive number");
  if (!settings.start.empty() && settings.start.size() != p.dofs())
    return fail(ec::invalid_argument, "the start value has the wrong length");
  return {};
}

refinement::refinement(conditions_view conditions, const element_operator& k,
                       const solve_settings& settings, solution& out)
    : conditions_(std::move(conditions)), k_(&k), settings_(&settings), out_(&out) {
  polled_resize(residual_, conditions_.loads.size());
  polled_resize(correction_, conditions_.loads.size());
  polled_resize(out.displacement, conditions_.prescribed.size());
  polled_for(out.displacement.size(),
             [&](std::size_t i) { out.displacement[i] = conditions_.prescribed[i]; });
  reference_ = start_residual();
  out.true_relative_residual = reference_ > 0 ? 1 : 0;
  if (!settings.start.empty())
    add_start();
  out.energy_error = out.true_relative_residual > 0 ? 1 : 0;  // Nobody knows yet.
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
  scale_ = norm_of(residual_);
  polled_for(residual_.size(), [&](std::size_t i) { residual_[i] /= scale_; });
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
  // Directions that are held stay so to double precision.
  apply_filter(conditions_.filter, correction_);
  polled_for(correction_.size(),
             [&](std::size_t i) { out_->displacement[i] += factor * correction_[i]; });
  update();
}

/// The residual of the prescribed displacement alone: mostly that is zero, and nothing to multiply.
double refinement::start_residual() {
  if (std::ranges::any_of(conditions_.prescribed, [](double u) { return u != 0; }))
    return residual_norm();
  polled_for(residual_.size(), [&](std::size_t i) { residual_[i] = conditions_.loads[i]; });
  apply_filter(conditions_.filter, residual_);
  return norm_of(residual_);
}

/// Adds the multiple of the start value d whose error has the least energy, alpha = d.r / d.Kd, and
/// carries residual and energy along: with the prescribed displacement g, d.Kg = d.f - d.r.
void refinement::add_start() {
  auto d = settings_->start;
  apply_filter(conditions_.filter, d);
  std::vector<double> kd(d.size());
  k_->apply(d, kd);
  apply_filter(conditions_.filter, kd);
  double work = 0;
  double by_loads = 0;
  double energy = 0;
  polled_for(d.size(), [&](std::size_t i) {
    work += d[i] * residual_[i];
    by_loads += d[i] * conditions_.loads[i];
    energy += d[i] * kd[i];
  });
  if (!(energy > 0) || !std::isfinite(work))
    return;
  const double alpha = work / energy;
  polled_for(d.size(), [&](std::size_t i) {
    out_->displacement[i] += alpha * d[i];
    residual_[i] -= alpha * kd[i];
  });
  energy_ = std::sqrt(
    std::max(0.0, energy_ * energy_ + 2 * alpha * (by_loads - work) + alpha * alpha * energy));
  out_->true_relative_residual = reference_ > 0 ? norm_of(residual_) / reference_ : 0;
}

double refinement::residual_norm() {
  k_->apply(out_->displacement, residual_);
  double twice_strain = 0;
  polled_for(residual_.size(), [&](std::size_t i) {
    twice_strain += residual_[i] * out_->displacement[i];
    residual_[i] = conditions_.loads[i] - residual_[i];
  });
  energy_ = std::sqrt(std::max(0.0, twice_strain));
  apply_filter(conditions_.filter, residual_);
  return norm_of(residual_);
}

void refinement::update() {
  const double now = residual_norm();
  out_->true_relative_residual = reference_ > 0 ? now / reference_ : 0;
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
