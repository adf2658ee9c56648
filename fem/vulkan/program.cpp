// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/program.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"

namespace tedit::fem::vulkan {

namespace {

std::uint32_t groups_of(std::uint32_t gate) {
  return std::min(1u << gate, 65535u);
}

std::uint32_t rows_of(const push_constants& push) {
  return push.rows - push.from;
}

/// The gate of the next power of two: kernels stride, so a few groups more do no harm.
std::uint32_t gate_of(std::uint32_t rows, std::uint32_t group_size, std::uint32_t most) {
  const std::uint32_t groups = std::min((rows - 1) / group_size + 1, most);
  return static_cast<std::uint32_t>(std::bit_width(groups - 1));
}

}  // namespace

std::vector<std::array<std::uint32_t, 4>> device_program::closed_gates() {
  std::vector<std::array<std::uint32_t, 4>> result(TEDIT_GATES);
  for (std::uint32_t gate = 0; gate < TEDIT_GATES; ++gate)
    result[gate] = {0, 1, 1, groups_of(gate)};
  return result;
}

void device_program::add_step(const gpu::kernel& k, const places& at, const push_constants& push,
                              std::uint32_t gate) {
  step now{&k, {}, push, gate};
  now.at.fill(std::ranges::find_if(at, [](const auto& place) { return place.second; })->second);
  for (const auto& [binding, buffer] : at)
    if (buffer)
      now.at[static_cast<std::size_t>(binding)] = buffer;
  steps_.push_back(now);
}

void device_program::add(const gpu::kernel& k, const places& at, const push_constants& push) {
  cut(push, [&](const push_constants& part) {
    add_step(k, at, part, gate_of(rows_of(part), kernels_.group_size, kernels_.most_groups));
  });
}

std::uint32_t device_program::add_sum(const gpu::kernel& k, const places& at,
                                      const push_constants& push) {
  std::uint32_t sums = 0;
  cut(push, [&](push_constants part) {
    const auto gate = gate_of(rows_of(part), kernels_.group_size, kernels_.sum_groups);
    part.first_sum = push.first_sum + sums;
    add_step(k, at, part, gate);
    sums += groups_of(gate);
  });
  return sums;
}

void device_program::add_single(const gpu::kernel& k, const places& at,
                                const push_constants& push) {
  add_step(k, at, push, 0);
}

expected<void> device_program::record(const gpu::buffer* gates) {
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
  parts_.clear();
  for (std::size_t first = 0, last = 0; first < steps_.size(); first = last) {
    std::uint64_t rows = 0;
    while (last < steps_.size() && rows < kernels_.rows_per_part)
      rows += rows_of(steps_[last++].push);
    auto part = record_part(std::span(steps_).subspan(first, last - first), sets, gates);
    if (!part)
      return fail(part.error());
    parts_.push_back(std::move(*part));
  }
  part_ms_.assign(parts_.size(), submission_ms);
  return {};
}

expected<gpu::commands> device_program::record_part(std::span<const step> steps,
                                                    const std::map<buffers, VkDescriptorSet>& sets,
                                                    const gpu::buffer* gates) const {
  auto work = gpu::commands::begin(kernels_.layout);
  if (!work)
    return work;
  for (const auto& s : steps) {
    work->use(sets.at(s.at));
    if (gates)
      work->dispatch_indirect(*s.kernel, *gates, 16 * std::uint64_t{s.gate}, &s.push);
    else
      work->dispatch(*s.kernel, groups_of(s.gate), &s.push);
  }
  if (auto ok = work->end(); !ok)
    return fail(ok.error());
  return work;
}

expected<void> device_program::run(int times) {
  const std::size_t all = parts_.size() * static_cast<std::size_t>(times);
  for (std::size_t done = 0; done < all;) {
    check_cancelled();
    const auto count = fitting(done % parts_.size(), all - done);
    if (auto ok = submit(done % parts_.size(), count); !ok)
      return ok;
    done += count;
  }
  return {};
}

/// How many parts from `first` on, in a circle, are worth one submission; at least one.
std::size_t device_program::fitting(std::size_t first, std::size_t most) const {
  double sum = part_ms_[first];
  std::size_t count = 1;
  while (count < most && sum < submission_ms) {
    sum += part_ms_[(first + count) % parts_.size()];
    count += sum <= submission_ms ? 1 : 0;
  }
  return count;
}

expected<void> device_program::submit(std::size_t first, std::size_t count) {
  std::vector<const gpu::commands*> list;
  double foreseen = 0;
  for (std::size_t i = 0; i < count; ++i) {
    list.push_back(&parts_[(first + i) % parts_.size()]);
    foreseen += part_ms_[(first + i) % parts_.size()];
  }
  const stopwatch clock;
  if (auto ok = gpu::commands::run_in_order(list); !ok)
    return ok;
  const double ms = std::max(clock.milliseconds(), 1e-3);
  // A part that was never measured went alone.
  const double change = count == 1 ? ms / foreseen : std::sqrt(ms / foreseen);
  for (std::size_t i = 0; i < std::min(count, parts_.size()); ++i)
    part_ms_[(first + i) % parts_.size()] *= change;
  return {};
}

}  // namespace tedit::fem::vulkan
