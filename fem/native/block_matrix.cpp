// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/block_matrix.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "fem/element.hpp"

namespace tedit::fem {

namespace {

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
        k[3 * i + j] +=
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
  k.block.assign(k.first[rows], block3{});
  parallel_for(rows, [&](std::size_t first, std::size_t last, std::size_t) {
    std::vector<std::uint32_t> columns;
    for (std::size_t row = first; row < last; ++row) {
      columns_of(p, corners, row, columns);
      std::ranges::copy(columns, k.column.begin() + k.first[row]);
      const auto blocks = std::span(k.block).subspan(k.first[row], columns.size());
      for (const auto corner : corners.of_node(row))
        add_element_row(p, gradients, corner, columns, blocks);
    }
  });
  return k;
}

void multiply(const block_matrix& k, std::span<const double> x, std::span<double> y) {
  parallel_for(k.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t row = first; row < last; ++row) {
      const double* own = &x[3 * row];
      double s0 = 0;
      double s1 = 0;
      double s2 = 0;
      for (auto i = k.first[row]; i < k.first[row + 1]; ++i) {
        const double* other = &x[3 * k.column[i]];
        const double d0 = other[0] - own[0];
        const double d1 = other[1] - own[1];
        const double d2 = other[2] - own[2];
        const auto& b = k.block[i];
        s0 += b[0] * d0 + b[1] * d1 + b[2] * d2;
        s1 += b[3] * d0 + b[4] * d1 + b[5] * d2;
        s2 += b[6] * d0 + b[7] * d1 + b[8] * d2;
      }
      y[3 * row] = s0;
      y[3 * row + 1] = s1;
      y[3 * row + 2] = s2;
    }
  });
}

std::vector<block3> diagonal_blocks(const block_matrix& k) {
  std::vector<block3> result(k.rows(), block3{});
  for (std::size_t row = 0; row < k.rows(); ++row)
    for (auto i = k.first[row]; i < k.first[row + 1]; ++i)
      for (int c = 0; c < 9; ++c)
        result[row][c] -= k.block[i][c];
  return result;
}

}  // namespace tedit::fem
