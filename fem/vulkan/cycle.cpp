// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/cycle.hpp"

#include <bit>

#include "fem/polled.hpp"

namespace tedit::fem::vulkan {

namespace {

row_lists::source members_of(const hierarchy& h) {
  return [&h](std::uint32_t aggregate, std::vector<std::uint32_t>& list) {
    const auto nodes = h.members.of(aggregate);
    list.insert(list.end(), nodes.begin(), nodes.end());
  };
}

}  // namespace

multilevel_cycle::multilevel_cycle(device_memory& memory, const row_operator& k, const hierarchy& h,
                                   filter_span filter, const cycle_settings& settings, double scale)
    : hierarchy_(h),
      settings_(settings),
      nodes_(k.rows()),
      smoother_(memory, k, h.smoother, filter, scale),
      rigid_(memory, h, settings, scale) {
  std::vector<std::array<std::uint32_t, 4>> arms(nodes_);
  polled_for(nodes_, [&](std::size_t n) { arms[n] = arm_of(static_cast<std::uint32_t>(n)); });
  arms_ = memory.put(arms);
  members_ = row_lists(memory, aggregates(), members_of(h));
}

std::array<std::uint32_t, 4> multilevel_cycle::arm_of(std::uint32_t node) const {
  std::array<std::uint32_t, 4> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::bit_cast<std::uint32_t>(hierarchy_.arm[node][i]);
  result[3] = hierarchy_.aggregate[node];
  return result;
}

void multilevel_cycle::update(filter_span filter, std::span<const std::uint32_t> nodes,
                              device_changes& changes) {
  smoother_.update(filter, nodes, changes);
  rigid_.update(hierarchy_, changes);
  changes.items(arms_, hierarchy_.changed, [this](std::uint32_t n) { return arm_of(n); });
  members_.update(hierarchy_.levels.front().changed, aggregates(), members_of(hierarchy_), changes);
}

void multilevel_cycle::add(device_program& program, const gpu::buffer& right,
                           const gpu::buffer& z) {
  const auto& kernels = program.kernels();
  smoother_.from_zero(program, settings_.node_degree, right, z);
  program.add(kernels.cycle_restrict,
              {{cycle_at::table, &members_.table()},
               {cycle_at::members, &members_.items()},
               {cycle_at::arms, &arms_},
               {cycle_at::residual, &smoother_.residual()},
               {cycle_at::right, &rigid_.right()}},
              cycle_push{aggregates(), 0, aggregates(), 0});
  rigid_.add(program);
  program.add(kernels.cycle_prolongate,
              {{cycle_at::arms, &arms_},
               {cycle_at::coarse, &rigid_.z()},
               {cycle_at::filter, &smoother_.filter()},
               {cycle_at::step, &smoother_.step()}},
              cycle_push{nodes_, 0, aggregates(), settings_.over_correction});
  smoother_.correction(program, settings_.node_degree, z);
}

}  // namespace tedit::fem::vulkan
