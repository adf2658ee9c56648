// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "base/sparse_numbers.hpp"
#include "fem/problem.hpp"

namespace tedit::fem {

/// A value for each of few nodes, in the order in which they were first asked for.
template <class T>
class node_table {
public:
  explicit node_table(const problem& p) : place_(p.node_count()) {}

  T& operator[](std::uint32_t node) {
    auto at = place_[node];
    if (at == sparse_numbers::none) {
      at = static_cast<std::uint32_t>(rows_.size());
      place_.set(node, at);
      rows_.emplace_back(node, T{});
    }
    return rows_[at].second;
  }

  [[nodiscard]] const std::vector<std::pair<std::uint32_t, T>>& rows() const { return rows_; }

private:
  sparse_numbers place_;
  std::vector<std::pair<std::uint32_t, T>> rows_;
};

}  // namespace tedit::fem
