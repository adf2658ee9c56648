// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/incidence.hpp"

#include <algorithm>

#include "base/parallel.hpp"
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

std::vector<std::vector<std::uint32_t>> corners_at(const problem& p,
                                                   std::span<const std::uint32_t> nodes) {
  if (nodes.empty())
    return {};
  std::vector<std::uint8_t> wanted(p.node_count(), 0);
  for (const auto n : nodes)
    wanted[n] = 1;
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  std::vector<std::vector<std::uint32_t>> found(chunk_count(p.element_count()));
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t chunk) {
    for (std::size_t e = first; e < last; ++e)
      for (std::size_t corner = per * e; corner < per * e + 4; ++corner)
        if (wanted[p.element_nodes[corner]] != 0)
          found[chunk].push_back(static_cast<std::uint32_t>(corner));
  });
  std::vector<std::vector<std::uint32_t>> result(nodes.size());
  for (const auto& part : found)
    for (const auto corner : part) {
      const auto at = std::ranges::lower_bound(nodes, p.element_nodes[corner]);
      result[static_cast<std::size_t>(at - nodes.begin())].push_back(corner);
    }
  return result;
}

}  // namespace tedit::fem
