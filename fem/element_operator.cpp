// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/element_operator.hpp"

#include <algorithm>

#include "fem/element_lanes.hpp"
#include "fem/node_numbering.hpp"
#include "fem/rows.hpp"

namespace tedit::fem {

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
    list_nodes(c * parallel_chunk, std::min(count, (c + 1) * parallel_chunk), chunks_[c].nodes);
  }
  share_nodes();
}

void element_chunks::list_nodes(std::size_t first, std::size_t last,
                                std::vector<std::uint32_t>& nodes) {
  constexpr std::uint32_t bits = 15;
  static_assert(10 * parallel_chunk < (1U << bits));
  const auto per = static_cast<std::size_t>(problem_.nodes_per_element);
  // Ascending nodes: neighbours in memory, corners before middles.
  thread_local node_numbering numbering(bits);
  numbering.number(std::span(problem_.element_nodes).subspan(per * first, per * (last - first)),
                   nodes, [&](std::size_t i, std::uint16_t at) { places_[per * first + i] = at; });
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
