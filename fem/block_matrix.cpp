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

/// The other corners of a node's elements, ascending, without duplicates.
void columns_of(const problem& p, const incidence& corners, std::size_t row,
                std::vector<std::uint32_t>& columns) {
  columns.clear();
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  for (const auto corner : corners.of_node(row)) {
    const std::size_t element = corner / per;
    for (std::uint32_t b = 0; b < 4; ++b)
      if (const auto node = p.element_nodes[element * per + b]; node != row)
        columns.push_back(node);
  }
  std::ranges::sort(columns);
  columns.erase(std::ranges::unique(columns).begin(), columns.end());
}

void add_element_row(const problem& p, const tet_gradients& g, std::uint32_t corner,
                     std::span<const std::uint32_t> columns, std::span<block3> blocks) {
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  const std::size_t e = corner / per;
  const int a = static_cast<int>(corner % per);
  const auto [lambda, mu] = p.constants[p.element_materials[e]];
  const vec3 ga = g.gradient[a];
  const std::array<double, 3> va{ga.x, ga.y, ga.z};
  for (int b = 0; b < 4; ++b) {
    if (b == a)
      continue;
    const auto node = p.element_nodes[per * e + b];
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

/// Gathers rows; `gradients_at(e)` gives the gradients of an element.
class row_gatherer {
public:
  row_gatherer(const problem& p, const incidence& corners) : p_(p), corners_(corners) {}

  std::span<const std::uint32_t> columns(std::size_t row) {
    columns_of(p_, corners_, row, columns_);
    return columns_;
  }

  /// Writes the row into its place, which has the length of `columns(row)`.
  template <class Gradients>
  void write(std::size_t row, Gradients&& gradients_at, block_matrix& k) {
    columns_of(p_, corners_, row, columns_);
    std::ranges::copy(columns_, k.column.begin() + k.begin(row));
    blocks_.assign(columns_.size(), block3{});
    const auto per = static_cast<std::uint32_t>(p_.nodes_per_element);
    for (const auto corner : corners_.of_node(row))
      add_element_row(p_, gradients_at(corner / per), corner, columns_, blocks_);
    float* out = &k.value[9 * std::size_t{k.begin(row)}];
    for (const auto& block : blocks_)
      for (const double value : block)
        *out++ = static_cast<float>(value);
  }

private:
  const problem& p_;
  const incidence& corners_;
  std::vector<std::uint32_t> columns_;
  std::vector<block3> blocks_;
};

}  // namespace

block_matrix assemble_blocks(const problem& p, const incidence& corners) {
  const std::size_t rows = p.corner_count;
  std::vector<tet_gradients> gradients(p.element_count());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e)
      gradients[e] = gradients_of(p, e);
  });
  std::vector<std::uint32_t> length(rows);
  parallel_for(rows, [&](std::size_t first, std::size_t last, std::size_t) {
    row_gatherer gatherer(p, corners);
    for (std::size_t row = first; row < last; ++row)
      length[row] = static_cast<std::uint32_t>(gatherer.columns(row).size());
  });
  block_matrix k;
  k.places = row_places(length);
  reserve_for_edits(k.column, k.places.room());
  reserve_for_edits(k.value, 9 * std::size_t{k.places.room()});
  k.column.resize(k.places.room());
  k.value.assign(9 * std::size_t{k.places.room()} + 1, 0);
  parallel_for(rows, [&](std::size_t first, std::size_t last, std::size_t) {
    row_gatherer gatherer(p, corners);
    for (std::size_t row = first; row < last; ++row)
      gatherer.write(
        row, [&](std::size_t e) -> const tet_gradients& { return gradients[e]; }, k);
  });
  return k;
}

void update_blocks(const problem& p, const incidence& corners, std::span<const std::uint32_t> nodes,
                   block_matrix& k) {
  row_gatherer gatherer(p, corners);
  while (k.rows() < p.corner_count)
    k.places.add(0);
  for (const auto row : nodes) {
    if (row >= p.corner_count)
      continue;
    k.places.replace(row, static_cast<std::uint32_t>(gatherer.columns(row).size()));
    k.column.resize(k.places.room());
    k.value.resize(9 * std::size_t{k.places.room()} + 1);
    gatherer.write(
      row, [&](std::size_t e) { return gradients_of(p, e); }, k);
  }
}

std::array<float, 6> diagonal_block(const block_matrix& k, std::size_t row) {
  constexpr std::array<int, 6> at{0, 3, 6, 4, 7, 8};
  std::array<double, 6> sum{};
  for (auto i = k.begin(row); i < k.end(row); ++i)
    for (int c = 0; c < 6; ++c)
      sum[c] -= static_cast<double>(k.value[9 * std::size_t{i} + at[c]]);
  std::array<float, 6> result;
  std::ranges::transform(sum, result.begin(), [](double v) { return static_cast<float>(v); });
  return result;
}

std::vector<std::array<float, 6>> diagonal_blocks(const block_matrix& k) {
  std::vector<std::array<float, 6>> result(k.rows());
  parallel_for(k.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t row = first; row < last; ++row)
      result[row] = diagonal_block(k, row);
  });
  return result;
}

std::array<float, 6> invert_block(const std::array<float, 6>& diagonal,
                                  const std::array<double, 6>& filter) {
  const auto full = [](const auto& s) {
    Eigen::Matrix3d m;
    m << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
    return m;
  };
  const Eigen::Matrix3d s = full(filter);
  const Eigen::Matrix3d d = full(diagonal);
  const double scale = d.trace() > 0 ? d.trace() / 3 : 1;
  const Eigen::Matrix3d held = scale * (Eigen::Matrix3d::Identity() - s);
  const Eigen::Matrix3d m = s * (s * d * s + held).inverse() * s;
  std::array<float, 6> result;
  int c = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      result[c++] = static_cast<float>(m(i, j));
  return result;
}

std::vector<std::array<float, 6>> invert_blocks(std::span<const std::array<float, 6>> diagonal,
                                                std::span<const std::array<double, 6>> filter) {
  std::vector<std::array<float, 6>> result(diagonal.size());
  parallel_for(diagonal.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      result[n] = invert_block(diagonal[n], filter[n]);
  });
  return result;
}

}  // namespace tedit::fem
