// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/krylov.hpp"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.hpp"

namespace tedit::fem::vulkan {

namespace {

constexpr int most_per_batch = 8;

/// Records `now` unless `kept` has the same steps already; after a failure nothing is kept.
expected<void> renew(std::optional<device_program>& kept, device_program&& now,
                     const gpu::buffer* gates = nullptr) {
  if (kept && kept->same_steps(now))
    return {};
  kept.emplace(std::move(now));
  auto recorded = kept->record(gates);
  if (!recorded)
    kept.reset();
  return recorded;
}

}  // namespace

krylov_solver::krylov_solver(const kernel_set& kernels, device_memory& memory,
                             const row_operator& k)
    : kernels_(kernels), memory_(memory), k_(k) {
  gates_ = memory.put(device_program::closed_gates());
  loops_.push_back({&kernels_});
  make_room(1);
}

/// Also for what the loops sum up.
void krylov_solver::make_room(std::uint32_t cases) {
  cases_ = cases;
  for (auto* vector : {&u_, &r_, &z_, &p_, &q_})
    memory_.replace(*vector, 16 * cases * with_spare(k_.rows()));
  std::uint64_t sums = 0;
  for (const auto& one : loops_)
    sums = std::max(sums, std::uint64_t{2} * one.kernels->cases * k_.most_partials(*one.kernels));
  memory_.replace(partials_, 4 * sums);
  memory_.replace(scalars_, cases * sizeof(krylov_scalars));
}

bool krylov_solver::has_width(std::uint32_t cases) const {
  return std::ranges::any_of(loops_,
                             [&](const recorded_loop& one) { return one.kernels->cases == cases; });
}

void krylov_solver::widen(const kernel_set& kernels) {
  loops_.push_back({&kernels});
  make_room(std::max(cases_, kernels.cases));
  product_.reset();
}

device_program krylov_solver::product_steps() const {
  device_program result(kernels_);
  k_.add(result, TEDIT_MULTIPLY, {.x = &p_, .r = &q_, .partials = &partials_}, {});
  return result;
}

expected<void> krylov_solver::prepare(const preconditioner& b, const gpu::buffer& filter) {
  smallest_ = usual_smallest;
  for (auto& one : loops_)
    for (auto* program : {&one.start, &one.preconditioned, &one.first, &one.iteration})
      program->reset();
  return follow(b, filter);
}

expected<void> krylov_solver::follow(const preconditioner& b, const gpu::buffer& filter) {
  if (product_)
    if (auto ok = renew(product_, product_steps()); !ok)
      return ok;
  for (auto& one : loops_)
    if (auto ok = record(one, b, filter); !ok)
      return ok;
  return {};
}

expected<void> krylov_solver::record(recorded_loop& one, const preconditioner& b,
                                     const gpu::buffer& filter) {
  const auto& kernels = *one.kernels;
  device_program start(kernels);
  start.add(kernels.krylov_start, vectors(&filter), every_row());
  if (auto ok = renew(one.start, std::move(start)); !ok)
    return ok;
  device_program once(kernels);
  b(once, r_, z_);
  if (auto ok = renew(one.preconditioned, std::move(once)); !ok)
    return ok;
  if (auto ok = renew(one.first, first_steps(kernels)); !ok)
    return ok;
  return renew(one.iteration, iteration_steps(kernels, b, filter), &gates_);
}

device_program::places krylov_solver::vectors(const gpu::buffer* filter) const {
  return {{krylov_at::u, &u_},
          {krylov_at::p, &p_},
          {krylov_at::q, &q_},
          {krylov_at::r, &r_},
          {krylov_at::filter, filter},
          {krylov_at::z, &z_},
          {krylov_at::partials, &partials_},
          {krylov_at::scalars, &scalars_},
          {krylov_at::gates, &gates_}};
}

/// p = z, and the scalars of the first iteration.
device_program krylov_solver::first_steps(const kernel_set& kernels) const {
  device_program first(kernels);
  first.add(kernels.krylov_first, vectors(), every_row());
  const auto sums = first.add_sum(kernels.krylov_product, vectors(), every_row());
  first.add_single(kernels.krylov_scalars[TEDIT_KRYLOV_BEGIN], vectors(),
                   krylov_push{.sums = sums});
  return first;
}

device_program krylov_solver::iteration_steps(const kernel_set& kernels, const preconditioner& b,
                                              const gpu::buffer& filter) const {
  device_program loop(kernels);
  const auto scalars = [&](std::uint32_t mode, std::uint32_t sums) {
    loop.add_single(kernels.krylov_scalars[mode], vectors(), krylov_push{.sums = sums});
  };
  scalars(TEDIT_KRYLOV_ALPHA,
          k_.add(loop, TEDIT_MULTIPLY, {.x = &p_, .r = &q_, .partials = &partials_}, {}));
  loop.add(kernels.krylov_advance, vectors(&filter), every_row());
  b(loop, r_, z_);
  scalars(TEDIT_KRYLOV_BETA, loop.add_sum(kernels.krylov_product, vectors(), every_row()));
  loop.add(kernels.krylov_turn, vectors(), every_row());
  return loop;
}

/// r = S r, u = 0, z = B r, p = z, and the scalars of the first iteration.
expected<void> krylov_solver::begin(recorded_loop& one, std::span<const inner_case> goals) {
  std::vector<krylov_scalars> scalars(one.kernels->cases);
  for (auto& of : scalars)
    of.smallest = static_cast<float>(smallest_);
  for (std::size_t c = 0; c < goals.size(); ++c) {
    const auto& goal = goals[c];
    scalars[c].reduction2 = static_cast<float>(goal.reduction * goal.reduction);
    scalars[c].enough = static_cast<float>(goal.residual_reduction * goal.residual_reduction);
    scalars[c].energy2 = static_cast<float>(goal.energy * goal.energy);
    scalars[c].share2 = static_cast<float>(goal.share * goal.share);
  }
  if (auto ok = memory_.upload(scalars_, scalars); !ok)
    return ok;
  for (auto* program : {&one.start, &one.preconditioned, &one.first})
    if (auto ok = (*program)->run(); !ok)
      return ok;
  return {};
}

/// Until all cases are done; their scalars.
expected<std::vector<krylov_scalars>> krylov_solver::iterate(recorded_loop& one, int max_iterations,
                                                             const execution& run) {
  std::vector<krylov_scalars> scalars(one.kernels->cases);
  int times = 0;
  for (;;) {
    const stopwatch clock;
    if (times > 0)
      if (auto ok = one.iteration->run(times); !ok)
        return fail(ok.error());
    if (auto ok = memory_.download(scalars_, scalars); !ok)
      return fail(ok.error());
    int iterations = 0;
    bool running = false;
    for (const auto& of : scalars) {
      iterations = std::max(iterations, static_cast<int>(of.iterations));
      running = running || of.state == TEDIT_KRYLOV_RUNNING;
    }
    if (!running || iterations >= max_iterations)
      return scalars;
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    const double fit =
      times > 0 ? device_program::submission_ms * times / std::max(clock.milliseconds(), 1e-3) : 1;
    times = static_cast<int>(std::clamp(fit, 1.0, double{most_per_batch}));
    times = std::min(times, max_iterations - iterations);
  }
}

/// What the scalars of one case say at the end.
inner_result krylov_solver::read(const krylov_scalars& of) {
  inner_result result;
  result.iterations = static_cast<int>(of.iterations);
  result.broke_down = of.state == TEDIT_KRYLOV_BROKEN_DOWN;
  const auto start = static_cast<double>(of.start);
  const double now = std::max(static_cast<double>(of.delta), 0.0);
  result.recurrence_reduction = start > 0 ? std::sqrt(now / start) : 0;
  energy_bound bound(smallest_);
  for (int i = 0; i < std::min(result.iterations, TEDIT_KRYLOV_KEPT); ++i) {
    bound.advance(static_cast<double>(of.alpha[i]), 0);
    bound.turn(static_cast<double>(of.beta[i]));
  }
  smallest_ = sharper_bound(smallest_, bound);
  result.energy = std::sqrt(static_cast<double>(of.radau) * now);
  result.gained = static_cast<double>(of.gained);
  return result;
}

expected<std::vector<inner_result>> krylov_solver::solve(const std::vector<device_float4>& right,
                                                         std::vector<device_float4>& correction,
                                                         std::span<const inner_case> goals,
                                                         int max_iterations, const execution& run) {
  const auto width = right.size() / k_.rows();
  auto& one = *std::ranges::find_if(
    loops_, [&](const recorded_loop& l) { return l.kernels->cases == width; });
  if (auto ok = memory_.upload(r_, right); !ok)
    return fail(ok.error());
  if (auto ok = begin(one, goals); !ok)
    return fail(ok.error());
  const auto scalars = iterate(one, max_iterations, run);
  if (!scalars)
    return fail(scalars.error());
  std::vector<inner_result> results;
  for (std::size_t c = 0; c < goals.size(); ++c)
    results.push_back(read((*scalars)[c]));
  if (auto ok = memory_.download(u_, correction); !ok)
    return fail(ok.error());
  return results;
}

expected<void> krylov_solver::multiply(const std::vector<device_float4>& x,
                                       std::vector<device_float4>& y) {
  if (!product_)
    if (auto ok = renew(product_, product_steps()); !ok)
      return ok;
  if (auto ok = memory_.upload(p_, x); !ok)
    return ok;
  if (auto ok = product_->run(); !ok)
    return ok;
  return memory_.download(q_, y);
}

expected<void> krylov_solver::precondition(const std::vector<device_float4>& r,
                                           std::vector<device_float4>& z) {
  if (auto ok = memory_.upload(r_, r); !ok)
    return ok;
  if (auto ok = loops_.front().preconditioned->run(); !ok)
    return ok;
  return memory_.download(z_, z);
}

}  // namespace tedit::fem::vulkan
