// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/block_matrix.hpp"

#include <Eigen/Dense>

#include <algorithm>

#include "base/parallel.hpp"
#include "fem/element.hpp"

namespace tedit::fem {

namespace {

/// A 3x3 block, column by column, N/m.
using block3 = std::array<double, 9>;

/// The other nodes of a node's elements, ascending, without duplicates.
void columns_of(const problem& p, const incidence& corners, std::size_t row,
                std::vector<std::uint32_t>& columns) {
  columns.clear();
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  for (const auto corner : corners.of_node(row)) {
    const auto element = corner / per;
    for (std::uint32_t b = 0; b < per; ++b)
      if (const auto node = p.element_nodes[element * per + b]; node != row)
        columns.push_back(node);
  }
  std::ranges::sort(columns);
  columns.erase(std::ranges::unique(columns).begin(), columns.end());
}

void add_element_row(const problem& p, const std::vector<tet_gradients>& gradients,
                     std::uint32_t corner, std::span<const std::uint32_t> columns,
                     std::span<block3> blocks) {
  const std::size_t e = corner / 4;
  const int a = static_cast<int>(corner % 4);
  const auto& g = gradients[e];
  const auto [lambda, mu] = p.constants[p.element_materials[e]];
  const vec3 ga = g.gradient[a];
  const std::array<double, 3> va{ga.x, ga.y, ga.z};
  for (int b = 0; b < 4; ++b) {
    if (b == a)
      continue;
    const auto node = p.element_nodes[4 * e + b];
    const auto at = std::ranges::lower_bound(columns, node) - columns.begin();
    auto& k = blocks[static_cast<std::size_t>(at)];
    const vec3 gb = g.gradient[b];
    const std::array<double, 3> vb{gb.x, gb.y, gb.z};
    const double both = mu * dot(ga, gb);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        k[3 * j + i] +=
          g.volume * (lambda * va[i] * vb[j] + mu * vb[i] * va[j] + (i == j ? both : 0));
  }
}

}  // namespace

block_matrix assemble_blocks(const problem& p, const incidence& corners) {
  const std::size_t rows = p.node_count();
  std::vector<tet_gradients> gradients(p.element_count());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e)
      gradients[e] = gradients_of(p, e);
  });
  block_matrix k;
  k.first.assign(rows + 1, 0);
  parallel_for(rows, [&](std::size_t first, std::size_t last, std::size_t) {
    std::vector<std::uint32_t> columns;
    for (std::size_t row = first; row < last; ++row) {
      columns_of(p, corners, row, columns);
      k.first[row + 1] = static_cast<std::uint32_t>(columns.size());
    }
  });
  for (std::size_t row = 0; row < rows; ++row)
    k.first[row + 1] += k.first[row];
  k.column.resize(k.first[rows]);
  k.value.assign(9 * std::size_t{k.first[rows]} + 1, 0);
  parallel_for(rows, [&](std::size_t first, std::size_t last, std::size_t) {
    std::vector<std::uint32_t> columns;
    std::vector<block3> blocks;
    for (std::size_t row = first; row < last; ++row) {
      columns_of(p, corners, row, columns);
      std::ranges::copy(columns, k.column.begin() + k.first[row]);
      blocks.assign(columns.size(), block3{});
      for (const auto corner : corners.of_node(row))
        add_element_row(p, gradients, corner, columns, blocks);
      float* out = &k.value[9 * std::size_t{k.first[row]}];
      for (const auto& block : blocks)
        for (const double value : block)
          *out++ = static_cast<float>(value);
    }
  });
  return k;
}

std::vector<std::array<float, 6>> diagonal_blocks(const block_matrix& k) {
  std::vector<std::array<float, 6>> result(k.rows());
  parallel_for(k.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    constexpr std::array<int, 6> at{0, 3, 6, 4, 7, 8};
    for (std::size_t row = first; row < last; ++row) {
      std::array<double, 6> sum{};
      for (auto i = k.first[row]; i < k.first[row + 1]; ++i)
        for (int c = 0; c < 6; ++c)
          sum[c] -= static_cast<double>(k.value[9 * std::size_t{i} + at[c]]);
      for (int c = 0; c < 6; ++c)
        result[row][c] = static_cast<float>(sum[c]);
    }
  });
  return result;
}

std::vector<std::array<float, 6>> invert_blocks(std::span<const std::array<float, 6>> diagonal,
                                                std::span<const std::array<double, 6>> filter) {
  const auto full = [](const auto& s) {
    Eigen::Matrix3d m;
    m << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
    return m;
  };
  std::vector<std::array<float, 6>> result(diagonal.size());
  parallel_for(diagonal.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      const Eigen::Matrix3d s = full(filter[n]);
      const Eigen::Matrix3d d = full(diagonal[n]);
      const double scale = d.trace() > 0 ? d.trace() / 3 : 1;
      const Eigen::Matrix3d held = scale * (Eigen::Matrix3d::Identity() - s);
      const Eigen::Matrix3d m = s * (s * d * s + held).inverse() * s;
      int c = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
          result[n][c++] = static_cast<float>(m(i, j));
    }
  });
  return result;
}

}  // namespace tedit::fem
