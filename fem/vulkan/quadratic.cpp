// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/quadratic.hpp"

#include <limits>

#include "fem/element.hpp"
#include "fem/multilevel/quadratic_level.hpp"
#include "fem/polled.hpp"

namespace tedit::fem::vulkan {

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

std::array<std::uint32_t, 12> element_nodes(const problem& p, std::size_t e) {
  std::array<std::uint32_t, 12> result{};
  std::copy_n(&p.element_nodes[10 * e], 10, result.begin());
  return result;
}

constexpr std::uint32_t fours_of(std::uint32_t forces) {
  return (forces + 3) / 4;
}

}  // namespace

quadratic_operator::quadratic_operator(const kernel_set& kernels, device_memory& memory,
                                       const problem& p, const device_scale& scale)
    : kernels_(kernels),
      memory_(memory),
      nodes_(static_cast<std::uint32_t>(p.node_count())),
      scale_(scale) {
  const std::uint64_t side = kernels.slice_rows;
  const std::uint64_t fit =
    std::max<std::uint64_t>(1, memory.most_per_piece() / force_bytes / side) * side;
  const auto count = static_cast<std::uint32_t>(p.element_count());
  const auto most = static_cast<std::uint32_t>(
    std::min<std::uint64_t>(std::numeric_limits<std::uint32_t>::max(), fit - fit / 16));
  std::uint64_t largest = 0;
  for (std::uint32_t first = 0; first < count; first += std::min(most, count - first)) {
    const auto elements = std::min(most, count - first);
    const bool last = first + elements == count;
    const std::uint64_t room = last ? std::min(fit, with_spare(elements)) : elements;
    add_range(p, first, first + elements, static_cast<std::uint32_t>(room));
    largest = std::max(largest, room);
  }
  forces_ = memory.room(force_bytes * ((largest + side - 1) / side * side));
  sums_ = memory.room(ranges_.size() > 1 ? 16 * with_spare(p.node_count()) : 0);
}

void quadratic_operator::add_range(const problem& p, std::uint32_t first, std::uint32_t last,
                                   std::uint32_t room) {
  const std::uint32_t count = last - first;
  auto& part = ranges_.emplace_back();
  part.first = first;
  part.elements = count;
  part.room = room;
  part.count.resize(nodes_, 0);
  std::vector<std::array<std::uint32_t, 12>> nodes(count);
  std::vector<std::array<device_float4, 3>> values(count);
  polled_for(count, [&](std::size_t e) {
    nodes[e] = element_nodes(p, first + e);
    values[e] = element_values(p, first + e, scale_);
    for (std::size_t a = 0; a < 10; ++a)
      ++part.count[nodes[e][a]];
  });
  std::vector<std::uint32_t> lengths(nodes_);
  std::ranges::transform(part.count, lengths.begin(), fours_of);
  part.places = roomy_places(lengths, 16, memory_.most_per_piece() / sizeof(four));
  std::vector<four> list(part.places.used());
  std::vector<std::uint32_t> done(nodes_, 0);
  polled_for(count, [&](std::size_t e) {
    for (std::uint32_t a = 0; a < 10; ++a) {
      const auto node = nodes[e][a];
      const auto k = done[node]++;
      list[part.places.begin(node) + k / 4][k % 4] = place_of(static_cast<std::uint32_t>(e), a);
    }
  });
  std::vector<std::array<std::uint32_t, 2>> rows(nodes_);
  polled_for(nodes_, [&](std::size_t n) { rows[n] = row_at(part, static_cast<std::uint32_t>(n)); });
  part.nodes = memory_.put(nodes, room);
  part.values = memory_.put(values, room);
  part.list = memory_.put(list, part.places.room());
  part.rows = memory_.put(rows, with_spare(nodes_));
}

std::uint32_t quadratic_operator::place_of(std::uint32_t element, std::uint32_t local) const {
  const auto side = kernels_.slice_rows;
  return (element / side * 10 + local) * side + element % side;
}

std::array<std::uint32_t, 2> quadratic_operator::row_at(const range& part, std::uint32_t node) {
  return {part.places.begin(node), part.count[node]};
}

// -- following an edit -------------------------------------------------------------------

void quadratic_operator::update(const problem& p, const incidence& corners,
                                const problem_change& change, device_changes& changes) {
  nodes_ = static_cast<std::uint32_t>(p.node_count());
  const auto count = static_cast<std::uint32_t>(p.element_count());
  auto& last = ranges_.back();
  if (count <= last.first || count - last.first > last.room ||
      (sums_.bytes() > 16 && sums_.bytes() < 16 * std::uint64_t{nodes_}))
    return changes.refuse();
  last.elements = count - last.first;
  for (auto& part : ranges_) {
    std::vector<std::uint32_t> inside;
    for (const auto e : change.elements)
      if (e >= part.first && e < part.first + part.elements)
        inside.push_back(e - part.first);
    changes.items(part.nodes, inside,
                  [&](std::uint32_t e) { return element_nodes(p, part.first + e); });
    changes.items(part.values, inside,
                  [&](std::uint32_t e) { return element_values(p, part.first + e, scale_); });
    update_rows(part, p, corners, change.nodes, changes);
  }
}

void quadratic_operator::update_rows(range& part, const problem& p, const incidence& corners,
                                     std::span<const std::uint32_t> nodes,
                                     device_changes& changes) {
  const auto forces_of = [&](std::uint32_t node) {
    auto forces = element_corners_at(p, corners, node);
    std::erase_if(forces, [&](std::uint32_t force) {
      return force / 10 < part.first || force / 10 >= part.first + part.elements;
    });
    return forces;
  };
  part.count.resize(nodes_, 0);
  for (const auto n : nodes)
    part.count[n] = static_cast<std::uint32_t>(forces_of(n).size());
  const auto length = [&](std::uint32_t node) { return fours_of(part.count[node]); };
  const auto dirty = part.places.update(nodes, nodes_, length, changes);
  changes.items(part.rows, dirty, [&](std::uint32_t n) { return row_at(part, n); });
  for (const auto n : dirty) {
    std::vector<four> list(length(n));
    std::size_t k = 0;
    for (const auto force : forces_of(n)) {
      list[k / 4][k % 4] = place_of(force / 10 - part.first, force % 10);
      ++k;
    }
    changes.put(part.list, part.places.begin(n), list);
  }
}

std::uint32_t quadratic_operator::add(device_program& program, std::uint32_t mode,
                                      const row_buffers& at, row_push push) const {
  std::uint32_t sums = 0;
  for (const auto& part : ranges_) {
    program.add(kernels_.quadratic_elements,
                {{quadratic_at::nodes, &part.nodes},
                 {quadratic_at::values, &part.values},
                 {row_at::x, at.x},
                 {quadratic_at::forces, &forces_}},
                row_push{.rows = part.elements});
    const bool last = &part == &ranges_.back();
    const std::uint32_t now = last ? mode : TEDIT_ACCUMULATE;
    const auto& kernel = kernels_.quadratic_rows[&part == &ranges_.front() ? 0 : 1][now];
    push.first_row = 0;
    push.rows = nodes_;
    const auto places = at.with({{quadratic_at::force_rows, &part.rows},
                                 {quadratic_at::force_list, &part.list},
                                 {quadratic_at::forces, &forces_},
                                 {quadratic_at::sums, &sums_}});
    if (now == TEDIT_MULTIPLY)
      sums = program.add_sum(kernel, places, push);
    else
      program.add(kernel, places, push);
  }
  return sums;
}

}  // namespace tedit::fem::vulkan
