// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/incidence.hpp"

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "fem/element_lanes.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

incidence::incidence(const problem& p, int locals)
    : locals_(static_cast<std::uint32_t>(std::min(p.nodes_per_element, locals))) {
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  const auto for_each_corner = [&](const auto& visit) {
    polled_for(p.element_count(), [&](std::size_t e) {
      const auto first = per * static_cast<std::uint32_t>(e);
      for (auto corner = first; corner < first + locals_; ++corner)
        visit(p.element_nodes[corner], corner);
    });
  };
  std::vector<std::uint32_t> next(locals_ == 4 ? p.corner_count : p.node_count(), 0);
  for_each_corner([&](std::uint32_t node, std::uint32_t) { ++next[node]; });
  places_ = row_places(next);
  reserve_for_edits(corners_, places_.room());
  polled_resize(corners_, places_.room());
  for (std::size_t n = 0; n < next.size(); ++n)
    next[n] = places_.begin(n);
  for_each_corner(
    [&](std::uint32_t node, std::uint32_t corner) { corners_[next[node]++] = corner; });
}

void incidence::update(const problem& p, std::span<const std::uint32_t> elements,
                       std::span<const std::uint32_t> nodes) {
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  // New corners of changed elements by node, in the elements' order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> fresh;
  for (const auto e : elements)
    for (std::uint32_t a = 0; a < locals_ && e < p.element_count(); ++a)
      fresh.emplace_back(p.element_nodes[per * std::size_t{e} + a], per * e + a);
  std::ranges::sort(fresh);
  auto next = fresh.begin();
  std::vector<std::uint32_t> row;
  for (const auto n : nodes) {
    if (locals_ == 4 && n >= p.corner_count)
      break;
    while (n >= places_.size())
      places_.add(0);
    row.clear();
    for (const auto corner : of_node(n))
      if (!std::ranges::binary_search(elements, corner / per))
        row.push_back(corner);
    for (; next != fresh.end() && next->first == n; ++next)
      row.push_back(next->second);
    std::ranges::sort(row);
    const auto at = places_.replace(n, static_cast<std::uint32_t>(row.size()));
    corners_.resize(places_.room());
    std::ranges::copy(row, corners_.begin() + at);
  }
}

// -- the operator ------------------------------------------------------------------

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

vec3 vec3_at(const double* x) {
  return {x[0], x[1], x[2]};
}

/// Adds the forces of elements to `force`; all arrays are by the chunk's numbers.
template <std::size_t Nodes>
TEDIT_INLINE void add_forces(const problem& p, std::size_t first, std::size_t last,
                             const std::uint16_t* local, const vec3* position, const vec3* value,
                             vec3* force) {
  for (std::size_t start = first; start < last; start += lane_count) {
    // Where elements run out the last one fills the lanes; its forces count once.
    const auto element = [&](std::size_t lane)
                           TEDIT_INLINED { return std::min(start + lane, last - 1); };
    const auto node = [&](std::size_t lane, std::size_t a)
                        TEDIT_INLINED { return local[Nodes * element(lane) + a]; };
    const auto gathered = [&](const vec3* x, std::size_t a) TEDIT_INLINED {
      return lanes3::of(x[node(0, a)], x[node(1, a)], x[node(2, a)], x[node(3, a)]);
    };
    const auto constants = [&](std::size_t lane) TEDIT_INLINED -> const lame_constants& {
      return p.constants[p.element_materials[element(lane)]];
    };
    const auto &a = constants(0), &b = constants(1), &c = constants(2), &d = constants(3);
    lane_elements elements;
    elements.lambda = lanes{a.lambda, b.lambda, c.lambda, d.lambda};
    elements.mu = lanes{a.mu, b.mu, c.mu, d.mu};
    std::array<lanes3, 4> corners;
    unrolled<4>([&](auto i) TEDIT_INLINED { corners[i] = gathered(position, i); });
    elements.set_corners(corners);
    std::array<lanes3, Nodes> u;
    unrolled<Nodes>([&](auto i) TEDIT_INLINED { u[i] = gathered(value, i); });
    const auto f = forces_of(u, elements);
    const std::size_t count = std::min(lane_count, last - start);
    unrolled<lane_count>([&](auto lane) TEDIT_INLINED {
      if (lane < count)
        unrolled<Nodes>([&](auto i) TEDIT_INLINED { force[node(lane, i)] += f[i].get(lane); });
    });
  }
}

}  // namespace

element_operator::element_operator(const problem& p)
    : problem_(p), chunks_(chunk_count(p.element_count())) {
  polled_resize(local_, p.element_nodes.size());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t c) {
    list_chunk_nodes(first, last, chunks_[c].nodes);
  });
  share_nodes();
}

void element_operator::update(std::span<const std::uint32_t> elements) {
  const std::size_t count = problem_.element_count();
  local_.resize(problem_.element_nodes.size());
  chunks_.resize(chunk_count(count));
  std::size_t listed = chunks_.size();
  for (const auto e : elements) {
    // What went was at the end, and its chunk may be gone or shorter.
    const std::size_t c = e / parallel_chunk;
    if (c >= chunks_.size() || c == listed)
      continue;
    listed = c;
    chunks_[c].nodes.clear();
    list_chunk_nodes(c * parallel_chunk, std::min(count, (c + 1) * parallel_chunk),
                     chunks_[c].nodes);
  }
  share_nodes();
}

void element_operator::list_chunk_nodes(std::size_t first, std::size_t last,
                                        std::vector<std::uint32_t>& nodes) {
  const auto per = static_cast<std::size_t>(problem_.nodes_per_element);
  small_numbering numbering;
  for (std::size_t i = per * first; i < per * last; ++i)
    local_[i] = numbering.number_of(problem_.element_nodes[i], nodes);
  // Ascending nodes: neighbours in memory, corners before middles.
  std::vector<std::uint16_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  std::ranges::sort(order, {}, [&](std::uint16_t i) { return nodes[i]; });
  std::vector<std::uint16_t> rank(nodes.size());
  for (std::size_t r = 0; r < order.size(); ++r)
    rank[order[r]] = static_cast<std::uint16_t>(r);
  for (std::size_t i = per * first; i < per * last; ++i)
    local_[i] = rank[local_[i]];
  std::ranges::sort(nodes);
}

void element_operator::share_nodes() {
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

/// Arrays that live for one application.
struct element_operator::chunk_scratch {
  std::span<double> result;
  std::vector<vec3> rims;  ///< By slot.
};

void element_operator::apply_chunk(std::span<const double> displacement, std::size_t first,
                                   std::size_t last, chunk_scratch& scratch) const {
  const auto& p = problem_;
  const auto& [nodes, slot] = chunks_[first / parallel_chunk];
  std::vector<vec3> own(3 * nodes.size());
  vec3* force = own.data();
  vec3* value = force + nodes.size();
  vec3* position = value + nodes.size();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    value[i] = vec3_at(&displacement[3 * std::size_t{nodes[i]}]);
    if (nodes[i] < p.corner_count)
      position[i] = p.nodes[nodes[i]];
  }
  run_wide_unfused([&] TEDIT_INLINED {
    if (p.element_order == 2)
      add_forces<10>(p, first, last, local_.data(), position, value, force);
    else
      add_forces<4>(p, first, last, local_.data(), position, value, force);
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (slot[i] != no_id) {
      scratch.rims[slot[i]] = force[i];
      continue;
    }
    double* to = &scratch.result[3 * std::size_t{nodes[i]}];
    to[0] = force[i].x;
    to[1] = force[i].y;
    to[2] = force[i].z;
  }
}

void element_operator::apply(std::span<const double> displacement, std::span<double> result) const {
  chunk_scratch scratch{result, std::vector<vec3>(shared_first_.back())};
  parallel_for(problem_.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    apply_chunk(displacement, first, last, scratch);
  });
  parallel_for(shared_.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      vec3 sum;  // Stays zero for a node without elements.
      for (std::size_t s = shared_first_[i]; s < shared_first_[i + 1]; ++s)
        sum += scratch.rims[s];
      double* to = &result[3 * std::size_t{shared_[i]}];
      to[0] = sum.x;
      to[1] = sum.y;
      to[2] = sum.z;
    }
  });
}

}  // namespace tedit::fem
