// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_krylov.hpp"

#include <cmath>

#include "base/stopwatch.hpp"

namespace tedit::fem {

namespace {

constexpr int most_per_batch = 8;

/// Records `now` unless `kept` has the same steps already; after a failure nothing is kept.
expected<void> renew(std::optional<vulkan_program>& kept, vulkan_program&& now,
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

vulkan_krylov::vulkan_krylov(const cycle_kernels& kernels, vulkan_memory& memory,
                             const row_operator& k)
    : kernels_(kernels), memory_(memory), k_(k) {
  for (auto* vector : {&u_, &r_, &z_, &p_, &q_})
    *vector = memory.room(16 * with_spare(k.rows()));
  partials_ = memory.room(4 * std::uint64_t{k.most_partials()});
  scalars_ = memory.room(4 * TEDIT_CG_SCALARS);
  gates_ = memory.put(vulkan_program::closed_gates());
}

vulkan_program vulkan_krylov::product_steps() const {
  vulkan_program result(kernels_);
  k_.add(result, TEDIT_MULTIPLY, {.x = &p_, .r = &q_, .partials = &partials_}, {});
  return result;
}

expected<void> vulkan_krylov::prepare(const preconditioner& b, const gpu::buffer& filter) {
  smallest_ = usual_smallest;
  for (auto* program : {&start_, &preconditioned_, &iteration_})
    program->reset();
  return follow(b, filter);
}

expected<void> vulkan_krylov::follow(const preconditioner& b, const gpu::buffer& filter) {
  if (product_)
    if (auto ok = renew(product_, product_steps()); !ok)
      return ok;
  vulkan_program start(kernels_);
  cycle_push push{};
  push.rows = k_.rows();
  start.add(kernels_.cg_start, {{0, &u_}, {3, &r_}, {4, &filter}}, push);
  if (auto ok = renew(start_, std::move(start)); !ok)
    return ok;
  vulkan_program once(kernels_);
  b(once, r_, z_);
  if (auto ok = renew(preconditioned_, std::move(once)); !ok)
    return ok;
  return renew(iteration_, iteration_steps(b, filter), &gates_);
}

vulkan_program vulkan_krylov::iteration_steps(const preconditioner& b,
                                              const gpu::buffer& filter) const {
  vulkan_program loop(kernels_);
  const auto scalars = [&](std::uint32_t mode, std::uint32_t sums) {
    cycle_push push{};
    push.rows = sums;
    loop.add_single(kernels_.cg_scalars[mode], {{7, &partials_}, {8, &scalars_}, {9, &gates_}},
                    push);
  };
  cycle_push push{};
  scalars(TEDIT_CG_ALPHA,
          k_.add(loop, TEDIT_MULTIPLY, {.x = &p_, .r = &q_, .partials = &partials_}, push));
  push.rows = k_.rows();
  loop.add(kernels_.cg_advance,
           {{0, &u_}, {1, &p_}, {2, &q_}, {3, &r_}, {4, &filter}, {8, &scalars_}}, push);
  b(loop, r_, z_);
  scalars(TEDIT_CG_BETA,
          loop.add_sum(kernels_.cg_product, {{2, &z_}, {3, &r_}, {7, &partials_}}, push));
  loop.add(kernels_.cg_turn, {{2, &z_}, {6, &p_}, {8, &scalars_}}, push);
  return loop;
}

/// r = S r, u = 0, z = B r, p = z, and the scalars of the first iteration.
expected<void> vulkan_krylov::begin(const inner_case& goal) {
  if (auto ok = start_->run(); !ok)
    return ok;
  if (auto ok = preconditioned_->run(); !ok)
    return ok;
  vulkan_program first(kernels_);
  cycle_push push{};
  push.rows = k_.rows();
  first.add(kernels_.cg_first, {{2, &z_}, {6, &p_}}, push);
  push.rows = first.add_sum(kernels_.cg_product, {{2, &z_}, {3, &r_}, {7, &partials_}}, push);
  push.reduction2 = static_cast<float>(goal.reduction * goal.reduction);
  push.energy2 = static_cast<float>(goal.energy * goal.energy);
  push.share2 = static_cast<float>(goal.share * goal.share);
  push.smallest = static_cast<float>(smallest_);
  first.add_single(kernels_.cg_scalars[TEDIT_CG_BEGIN],
                   {{7, &partials_}, {8, &scalars_}, {9, &gates_}}, push);
  if (auto ok = first.record(); !ok)
    return ok;
  return first.run();
}

expected<inner_result> vulkan_krylov::solve(const std::vector<device_float4>& right,
                                            std::vector<device_float4>& correction,
                                            const inner_case& goal, int max_iterations,
                                            const execution& run) {
  if (auto ok = memory_.upload(r_, right); !ok)
    return fail(ok.error());
  if (auto ok = begin(goal); !ok)
    return fail(ok.error());
  std::vector<float> scalars(TEDIT_CG_SCALARS);
  inner_result result;
  int times = 0;
  for (;;) {
    const stopwatch clock;
    if (times > 0)
      if (auto ok = iteration_->run(times); !ok)
        return fail(ok.error());
    if (auto ok = memory_.download(scalars_, scalars); !ok)
      return fail(ok.error());
    result.iterations = static_cast<int>(scalars[TEDIT_CG_ITERATIONS]);
    if (scalars[TEDIT_CG_STATE] != 0 || result.iterations >= max_iterations)
      break;
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    const double fit =
      times > 0 ? vulkan_program::submission_ms * times / std::max(clock.milliseconds(), 1e-3) : 1;
    times = static_cast<int>(std::clamp(fit, 1.0, double{most_per_batch}));
    times = std::min(times, max_iterations - result.iterations);
  }
  result.broke_down = scalars[TEDIT_CG_STATE] == 2;
  const auto start = static_cast<double>(scalars[TEDIT_CG_START]);
  const double now = std::max(static_cast<double>(scalars[TEDIT_CG_DELTA]), 0.0);
  result.recurrence_reduction = start > 0 ? std::sqrt(now / start) : 0;
  energy_bound bound(smallest_);
  for (int i = 0; i < std::min(result.iterations, TEDIT_CG_KEPT); ++i) {
    bound.advance(static_cast<double>(scalars[TEDIT_CG_HISTORY + 2 * i]), 0);
    bound.turn(static_cast<double>(scalars[TEDIT_CG_HISTORY + 2 * i + 1]));
  }
  smallest_ = sharper_bound(smallest_, bound);
  result.energy = std::sqrt(static_cast<double>(scalars[TEDIT_CG_RADAU]) * now);
  result.gained = static_cast<double>(scalars[TEDIT_CG_GAINED]);
  if (auto ok = memory_.download(u_, correction); !ok)
    return fail(ok.error());
  return result;
}

expected<void> vulkan_krylov::multiply(const std::vector<device_float4>& x,
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

expected<void> vulkan_krylov::precondition(const std::vector<device_float4>& r,
                                           std::vector<device_float4>& z) {
  if (auto ok = memory_.upload(r_, r); !ok)
    return ok;
  if (auto ok = preconditioned_->run(); !ok)
    return ok;
  return memory_.download(z_, z);
}

}  // namespace tedit::fem
