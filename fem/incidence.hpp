// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "fem/problem.hpp"
#include "fem/rows.hpp"

namespace tedit::fem {

/// Which element corners meet at each node: entries are element * nodes_per_element + local node,
/// ascending, so that sums over them have one order. Cost: O(elements).
class incidence {
public:
  /// `locals`: only the first ones of each element's nodes count; 4 for its corners, and then only
  /// corner nodes have rows.
  explicit incidence(const problem& p, int locals = 10);

  [[nodiscard]] std::span<const std::uint32_t> of_node(std::size_t node) const {
    return places_.of(node, corners_);
  }

  /// After `elements` changed: the rows of `nodes` anew, which must hold every node that the
  /// elements had or have; ascending, both. Cost: O(rows).
  void update(const problem& p, std::span<const std::uint32_t> elements,
              std::span<const std::uint32_t> nodes);

  /// Updates have left so many holes that building anew is better.
  [[nodiscard]] bool crowded() const { return places_.crowded(); }

private:
  std::uint32_t locals_;
  row_places places_;
  std::vector<std::uint32_t> corners_;
};

/// Element corners at some corner nodes only, ascending: entry i has those of `nodes[i]`, as
/// `incidence` counts them. `nodes`: ascending. Cost: a look at every element, on all cores.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> corners_at(
  const problem& p, std::span<const std::uint32_t> nodes);

}  // namespace tedit::fem
