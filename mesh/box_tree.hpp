// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/box.hpp"

namespace tedit {

/// Boxes of which those that meet another box are found without a look at all of them.
class box_tree {
public:
  /// Cost: O(n log n).
  explicit box_tree(const std::vector<box>& boxes);

  /// Around all boxes.
  [[nodiscard]] box extent() const { return nodes_.empty() ? box{} : nodes_.front().extent; }

  /// Calls `matches(i)` for each box i that meets `within` until it returns true; has it? The order
  /// is the tree's own. Cost: O(log n + boxes that meet), more where many boxes overlap.
  template <class Matches>
  [[nodiscard]] bool any_meeting(const box& within, const Matches& matches) const {
    for (std::size_t n = 0; n < nodes_.size();) {
      const auto& at = nodes_[n];
      const bool meets = at.extent.meets(within);
      if (meets && at.box != none && matches(std::size_t{at.box}))
        return true;
      n = meets ? n + 1 : at.past;
    }
    return false;
  }

private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// What is below a node follows it: a walk needs no stack.
  struct node {
    tedit::box extent;
    std::uint32_t past = 0;    ///< The first node that is not below this one.
    std::uint32_t box = none;  ///< Of a leaf.
  };

  void add_nodes(const std::vector<tedit::box>& boxes, std::uint32_t* first, std::uint32_t* last);

  std::vector<node> nodes_;
};

}  // namespace tedit
