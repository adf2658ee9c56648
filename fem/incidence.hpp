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

/// K u in fp64 from the elements, without a matrix: the measure of every residual and reaction.
///
/// Elements are taken in chunks that follow space. A chunk fetches the values of its nodes once,
/// sums the forces of its elements among them, writes those of nodes that no other chunk has, and
/// leaves the rest (the rim of the chunk) for a second pass over the shared nodes. All sums have a
/// fixed order, so the bits do not depend on the number of threads; and the temporary is the rims
/// instead of all element forces.
class element_operator {
public:
  /// `p` must outlive the operator. Cost: O(elements), on all cores. Memory: 2 bytes per element
  /// and local node, about 20 per node.
  explicit element_operator(const problem& p);

  /// After `elements` (ascending) of the problem changed, some may be gone. Cost: their chunks, and
  /// a look at every chunk's list.
  void update(std::span<const std::uint32_t> elements);

  /// result = K u, N, 3 per node. Cost: O(elements), on all cores, the same bits every time.
  void apply(std::span<const double> displacement, std::span<double> result) const;

private:
  struct chunk_scratch;
  struct chunk {
    std::vector<std::uint32_t> nodes;  ///< Ascending: corners come first.
    std::vector<std::uint32_t> slot;   ///< Of each node among the shared; or `no_id`.
  };

  void list_chunk_nodes(std::size_t first, std::size_t last, std::vector<std::uint32_t>& nodes);
  void share_nodes();
  void apply_chunk(std::span<const double> displacement, std::size_t first, std::size_t last,
                   chunk_scratch& scratch) const;

  const problem& problem_;
  std::vector<std::uint16_t> local_;  ///< Of each element node, in its chunk's list.
  std::vector<chunk> chunks_;
  std::vector<std::uint32_t> shared_;        ///< Nodes of several chunks, ascending.
  std::vector<std::uint32_t> shared_first_;  ///< Start of each one's slots.
};

}  // namespace tedit::fem
