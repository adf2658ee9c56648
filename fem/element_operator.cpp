// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/element_operator.hpp"

#include <algorithm>
#include <numeric>

#include "fem/element_lanes.hpp"
#include "fem/rows.hpp"

namespace tedit::fem {

namespace {

/// Numbers the distinct values of a chunk by first appearance: an open hash table, since sorting
/// all of them would cost more than several applications of the operator.
class small_numbering {
public:
  std::uint16_t number_of(std::uint32_t value, std::vector<std::uint32_t>& list) {
    for (std::uint32_t at = value * 2654435761u >> shift;; at = (at + 1) & mask) {
      if (keys_[at] == value)
        return numbers_[at];
      if (keys_[at] != no_id)
        continue;
      keys_[at] = value;
      numbers_[at] = static_cast<std::uint16_t>(list.size());
      list.push_back(value);
      return numbers_[at];
    }
  }

private:
  // At most 10 * parallel_chunk = 20480 values.
  static constexpr std::uint32_t bits = 15;
  static constexpr std::uint32_t shift = 32 - bits;
  static constexpr std::uint32_t mask = (1u << bits) - 1;
  static_assert(10 * parallel_chunk < (1u << bits));

  std::vector<std::uint32_t> keys_ = std::vector<std::uint32_t>(1u << bits, no_id);
  std::vector<std::uint16_t> numbers_ = std::vector<std::uint16_t>(1u << bits);
};

}  // namespace

element_chunks::element_chunks(const problem& p)
    : problem_(p), chunks_(chunk_count(p.element_count())) {
  reserve_for_edits(places_, p.element_nodes.size());
  polled_resize(places_, p.element_nodes.size());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t c) {
    list_nodes(first, last, chunks_[c].nodes);
  });
  share_nodes();
}

void element_chunks::update(std::span<const std::uint32_t> elements) {
  const std::size_t count = problem_.element_count();
  places_.resize(problem_.element_nodes.size());
  chunks_.resize(chunk_count(count));
  std::size_t listed = chunks_.size();
  for (const auto e : elements) {
    // What went was at the end, and its chunk may be gone or shorter.
    const std::size_t c = e / parallel_chunk;
    if (c >= chunks_.size() || c == listed)
      continue;
    listed = c;
    chunks_[c].nodes.clear();
    list_nodes(c * parallel_chunk, std::min(count, (c + 1) * parallel_chunk), chunks_[c].nodes);
  }
  share_nodes();
}

void element_chunks::list_nodes(std::size_t first, std::size_t last,
                                std::vector<std::uint32_t>& nodes) {
  const auto per = static_cast<std::size_t>(problem_.nodes_per_element);
  small_numbering numbering;
  for (std::size_t i = per * first; i < per * last; ++i)
    places_[i] = numbering.number_of(problem_.element_nodes[i], nodes);
  // Ascending nodes: neighbours in memory, corners before middles.
  std::vector<std::uint16_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  std::ranges::sort(order, {}, [&](std::uint16_t i) { return nodes[i]; });
  std::vector<std::uint16_t> rank(nodes.size());
  for (std::size_t r = 0; r < order.size(); ++r)
    rank[order[r]] = static_cast<std::uint16_t>(r);
  for (std::size_t i = per * first; i < per * last; ++i)
    places_[i] = rank[places_[i]];
  std::ranges::sort(nodes);
}

void element_chunks::share_nodes() {
  constexpr std::size_t chunks_between = 32;
  std::vector<std::uint32_t> users(problem_.node_count(), 0);
  polled_for(
    chunks_.size(),
    [&](std::size_t c) {
      for (const auto node : chunks_[c].nodes)
        ++users[node];
    },
    chunks_between);
  shared_.clear();
  shared_first_.assign(1, 0);
  std::vector<std::uint32_t> next(problem_.node_count(), no_id);
  polled_for(users.size(), [&](std::size_t n) {
    if (users[n] == 1)
      return;
    next[n] = shared_first_.back();
    shared_.push_back(static_cast<std::uint32_t>(n));
    shared_first_.push_back(next[n] + users[n]);
  });
  polled_for(
    chunks_.size(),
    [&](std::size_t c) {
      auto& part = chunks_[c];
      part.slot.resize(part.nodes.size());
      for (std::size_t i = 0; i < part.slot.size(); ++i) {
        auto& at = next[part.nodes[i]];
        part.slot[i] = at == no_id ? no_id : at++;
      }
    },
    chunks_between);
}

namespace {

/// Adds the forces of elements to `force`, by the places of their nodes.
template <std::size_t Nodes>
TEDIT_INLINE void add_forces(const chunk_elements& elements, std::array<double, 3>* force) {
  for_each_lanes<Nodes>(elements, [&](const lane_group<Nodes>& group) TEDIT_INLINED {
    const auto f = forces_of(group.value, group.elements);
    unrolled<lane_count>([&](std::size_t lane) TEDIT_INLINED {
      if (lane < group.count)
        unrolled<Nodes>([&](auto i) TEDIT_INLINED {
          auto& to = force[group.place(lane, i)];
          to[0] += f[i].x[lane];
          to[1] += f[i].y[lane];
          to[2] += f[i].z[lane];
        });
    });
  });
}

}  // namespace

void element_operator::apply(std::span<const double> displacement, std::span<double> result) const {
  const auto fill = [&](std::size_t first, std::size_t last, std::size_t c,
                        std::array<double, 3>* force) {
    const chunk_elements elements(problem_, chunks_, c, first, last, displacement);
    run_wide_unfused([&]() TEDIT_INLINED {
      if (problem_.element_order == 2)
        add_forces<10>(elements, force);
      else
        add_forces<4>(elements, force);
    });
  };
  chunks_.sum_at_nodes<3>(fill, [&](std::size_t node, const std::array<double, 3>& sum) {
    std::ranges::copy(sum, &result[3 * node]);
  });
}

}  // namespace tedit::fem
