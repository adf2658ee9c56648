// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "fem/problem.hpp"

namespace tedit::fem {

/// Which element corners meet at each node: entries are element * nodes_per_element + local node,
/// ascending, so that sums over them have one order. Cost: O(elements).
class incidence {
public:
  explicit incidence(const problem& p);

  [[nodiscard]] std::span<const std::uint32_t> of_node(std::size_t node) const {
    return std::span(corners_).subspan(first_[node], first_[node + 1] - first_[node]);
  }

private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> corners_;
};

/// K u in fp64 from the elements, without a matrix: the measure of every residual and reaction.
class element_operator {
public:
  /// `p` must outlive the operator.
  explicit element_operator(const problem& p) : problem_(p), incidence_(p) {}

  /// result = K u, N, 3 per node. Cost: O(elements), on all cores, the same bits every time.
  void apply(std::span<const double> displacement, std::span<double> result) const;

  [[nodiscard]] const incidence& corners() const { return incidence_; }

private:
  const problem& problem_;
  incidence incidence_;
};

}  // namespace tedit::fem
