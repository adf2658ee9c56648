// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace tedit {

box_tree::box_tree(const std::vector<box>& boxes) {
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(2 * boxes.size());
  if (!boxes.empty())
    add_nodes(boxes, order.data(), order.data() + order.size());
}

/// The boxes from `first` on in a node, halved across its longest side until one is left.
void box_tree::add_nodes(const std::vector<tedit::box>& boxes, std::uint32_t* first,
                         std::uint32_t* last) {
  const std::size_t here = nodes_.size();
  nodes_.emplace_back();
  tedit::box extent;
  for (const auto* i = first; i != last; ++i)
    extent.add(boxes[*i]);
  if (last - first == 1) {
    nodes_[here].box = *first;
  } else {
    const vec3 size = extent.high - extent.low;
    const double longest = std::max({size.x, size.y, size.z});
    const auto side = size.x == longest ? &vec3::x : size.y == longest ? &vec3::y : &vec3::z;
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](std::uint32_t i, std::uint32_t j) {
      return boxes[i].low.*side + boxes[i].high.*side < boxes[j].low.*side + boxes[j].high.*side;
    });
    add_nodes(boxes, first, middle);
    add_nodes(boxes, middle, last);
  }
  nodes_[here].extent = extent;
  nodes_[here].past = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace tedit
