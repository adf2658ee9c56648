// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/types.hpp"

namespace tedit::fem {

/// Numbers the nodes of a few elements among themselves. The table of 6 * 2^`bits` bytes is used
/// again and again, so that it stays in a near cache: sorting all nodes of the elements would cost
/// more than several products with them.
class node_numbering {
public:
  /// For fewer than 2^bits different nodes; half as many keep it quick.
  explicit node_numbering(std::uint32_t bits)
      : shift_(32 - bits), key_(std::size_t{1} << bits), number_(key_.size()) {}

  /// Makes `nodes` the different ones of `all`, ascending, and calls `place(i, number)` with the
  /// number of all[i] among them for every i, in order.
  template <class Place>
  void number(std::span<const std::uint32_t> all, std::vector<std::uint32_t>& nodes,
              const Place& place) {
    std::ranges::fill(key_, no_id);
    nodes.clear();
    for (const auto node : all)
      if (auto& key = key_[slot_of(node)]; key == no_id)
        nodes.push_back(key = node);
    std::ranges::sort(nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      number_[slot_of(nodes[i])] = static_cast<std::uint16_t>(i);
    for (std::size_t i = 0; i < all.size(); ++i)
      place(i, number_[slot_of(all[i])]);
  }

private:
  /// The node's own slot, or the free one that it would take.
  [[nodiscard]] std::size_t slot_of(std::uint32_t node) const {
    std::size_t slot = (node * 0x9E3779B9U) >> shift_;
    while (key_[slot] != node && key_[slot] != no_id)
      slot = (slot + 1) % key_.size();
    return slot;
  }

  std::uint32_t shift_;
  std::vector<std::uint32_t> key_;
  std::vector<std::uint16_t> number_;
};

}  // namespace tedit::fem
