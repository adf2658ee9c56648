// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_quadratic.hpp"

#include <numeric>

#include "fem/element.hpp"

namespace tedit::fem {

namespace {

constexpr std::uint64_t force_bytes = 10 * 16;  // of an element

/// Gradients of L_1, L_2, L_3 and Lame's constants times V/20, all divided by the scale.
std::array<device_float4, 3> element_values(const problem& p, std::size_t e,
                                            const device_scale& scale) {
  const auto g = gradients_of(p, e);
  const auto& c = p.constants[p.element_materials[e]];
  const double weight = g.volume / (20 * scale.size * scale.size * scale.size * scale.stiffness);
  std::array<device_float4, 3> result{};
  for (int b = 0; b < 3; ++b) {
    const vec3 d = g.gradient[b + 1] * scale.size;
    result[b] = {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z), 0};
  }
  result[0][3] = static_cast<float>(c.lambda * weight);
  result[1][3] = static_cast<float>(c.mu * weight);
  return result;
}

/// The places of each node's forces, four by four; fills in where each row begins.
std::vector<std::array<std::uint32_t, 4>> force_lists(
  const std::vector<std::array<std::uint32_t, 12>>& nodes,
  std::vector<std::array<std::uint32_t, 2>>& rows) {
  std::uint32_t end = 0;
  for (auto& row : rows) {
    row[0] = end;
    end += (row[1] + 3) / 4;
  }
  std::vector<std::array<std::uint32_t, 4>> result(end);
  std::vector<std::uint32_t> done(rows.size(), 0);
  for (std::size_t e = 0; e < nodes.size(); ++e)
    for (std::size_t a = 0; a < 10; ++a) {
      const auto node = nodes[e][a];
      const auto k = done[node]++;
      result[rows[node][0] + k / 4][k % 4] = static_cast<std::uint32_t>(a * nodes.size() + e);
    }
  return result;
}

}  // namespace

expected<std::unique_ptr<vulkan_quadratic>> vulkan_quadratic::make(const cycle_kernels& kernels,
                                                                   vulkan_memory& memory,
                                                                   const problem& p,
                                                                   const device_scale& scale) {
  std::unique_ptr<vulkan_quadratic> result(
    new vulkan_quadratic(kernels, memory, static_cast<std::uint32_t>(p.node_count())));
  const std::size_t most = std::max<std::size_t>(1, memory.most_per_piece() / force_bytes);
  const std::size_t count = p.element_count();
  for (std::size_t first = 0; first < count; first += most)
    result->add_range(p, scale, first, std::min(count, first + most));
  result->forces_ = memory.room(force_bytes * std::min(most, count));
  result->sums_ = memory.room(result->ranges_.size() > 1 ? 16 * p.node_count() : 0);
  if (auto ok = memory.status(); !ok)
    return fail(ok.error());
  return result;
}

void vulkan_quadratic::add_range(const problem& p, const device_scale& scale, std::size_t first,
                                 std::size_t last) {
  const std::size_t count = last - first;
  std::vector<std::array<std::uint32_t, 12>> nodes(count);
  std::vector<std::array<device_float4, 3>> values(count);
  std::vector<std::array<std::uint32_t, 2>> rows(p.node_count());
  for (std::size_t e = 0; e < count; ++e) {
    std::copy_n(&p.element_nodes[10 * (first + e)], 10, nodes[e].begin());
    values[e] = element_values(p, first + e, scale);
    for (int a = 0; a < 10; ++a)
      ++rows[nodes[e][a]][1];
  }
  range made;
  made.elements = static_cast<std::uint32_t>(count);
  made.nodes = memory_.put(nodes);
  made.values = memory_.put(values);
  made.list = memory_.put(force_lists(nodes, rows));
  made.rows = memory_.put(rows);
  ranges_.push_back(std::move(made));
}

std::uint32_t vulkan_quadratic::add(vulkan_program& program, std::uint32_t mode,
                                    const row_buffers& at, cycle_push push) const {
  std::uint32_t sums = 0;
  for (const auto& part : ranges_) {
    cycle_push elements{};
    elements.rows = part.elements;
    program.add(kernels_.quadratic_elements,
                {{0, &part.nodes}, {1, &part.values}, {2, at.x}, {8, &forces_}}, elements);
    const bool last = &part == &ranges_.back();
    const std::uint32_t now = last ? mode : TEDIT_ACCUMULATE;
    const auto& kernel = kernels_.quadratic_rows[&part == &ranges_.front() ? 0 : 1][now];
    push.first_row = 0;
    push.rows = nodes_;
    const std::initializer_list<vulkan_program::place> places{
      {0, &part.rows},
      {1, &part.list},
      {2, at.x},
      {3, at.r},
      {4, at.diagonal ? at.diagonal : at.x},
      {5, at.other ? at.other : &sums_},
      {6, at.z ? at.z : &sums_},
      {7, at.partials ? at.partials : &sums_},
      {8, &forces_},
      {9, &sums_}};
    if (now == TEDIT_MULTIPLY)
      sums = program.add_sum(kernel, places, push);
    else
      program.add(kernel, places, push);
  }
  return sums;
}

}  // namespace tedit::fem
