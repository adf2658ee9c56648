// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_program.hpp"

#include <algorithm>
#include <bit>
#include <map>

namespace tedit::fem {

namespace {

std::uint32_t groups_of(std::uint32_t gate) {
  return std::min(1u << gate, 65535u);
}

/// The gate of the next power of two: kernels stride, so a few groups more do no harm.
std::uint32_t gate_of(std::uint32_t rows, std::uint32_t group_size, std::uint32_t most) {
  const std::uint32_t groups = std::min((rows - 1) / group_size + 1, most);
  return static_cast<std::uint32_t>(std::bit_width(groups - 1));
}

}  // namespace

std::vector<std::array<std::uint32_t, 4>> vulkan_program::closed_gates() {
  std::vector<std::array<std::uint32_t, 4>> result(TEDIT_GATES);
  for (std::uint32_t gate = 0; gate < TEDIT_GATES; ++gate)
    result[gate] = {0, 1, 1, groups_of(gate)};
  return result;
}

void vulkan_program::add_step(const gpu::kernel& k, std::initializer_list<place> places,
                              const cycle_push& push, std::uint32_t gate) {
  step now{&k, {}, push, gate};
  now.at.fill(places.begin()->second);
  for (const auto& [binding, buffer] : places)
    now.at[static_cast<std::size_t>(binding)] = buffer;
  steps_.push_back(now);
}

void vulkan_program::add(const gpu::kernel& k, std::initializer_list<place> places,
                         const cycle_push& push) {
  if (push.rows > 0)
    add_step(k, places, push, gate_of(push.rows, kernels_.group_size, kernels_.most_groups));
}

std::uint32_t vulkan_program::add_sum(const gpu::kernel& k, std::initializer_list<place> places,
                                      const cycle_push& push) {
  if (push.rows == 0)
    return 0;
  const auto gate = gate_of(push.rows, kernels_.group_size, kernels_.sum_groups);
  add_step(k, places, push, gate);
  return groups_of(gate);
}

void vulkan_program::add_single(const gpu::kernel& k, std::initializer_list<place> places,
                                const cycle_push& push) {
  add_step(k, places, push, 0);
}

expected<void> vulkan_program::record(const gpu::buffer* gates) {
  std::map<buffers, VkDescriptorSet> sets;
  for (const auto& s : steps_)
    sets.emplace(s.at, VK_NULL_HANDLE);
  auto pool = gpu::binding_pool::make(kernels_.layout, static_cast<std::uint32_t>(sets.size()));
  if (!pool)
    return fail(pool.error());
  pool_.emplace(std::move(*pool));
  for (auto& [at, set] : sets) {
    auto bound = pool_->bind(at);
    if (!bound)
      return fail(bound.error());
    set = *bound;
  }
  auto work = gpu::commands::begin(kernels_.layout);
  if (!work)
    return fail(work.error());
  for (const auto& s : steps_) {
    work->use(sets.at(s.at));
    if (gates)
      work->dispatch_indirect(*s.kernel, *gates, 16 * std::uint64_t{s.gate}, &s.push);
    else
      work->dispatch(*s.kernel, groups_of(s.gate), &s.push);
  }
  if (auto ok = work->end(); !ok)
    return ok;
  commands_.emplace(std::move(*work));
  return {};
}

expected<void> vulkan_program::run(int times) {
  return commands_->run(times);
}

}  // namespace tedit::fem
