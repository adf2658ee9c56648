// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/block_matrix.hpp"

#include <Eigen/Dense>

#include <algorithm>

#include "base/parallel.hpp"
#include "fem/column_table.hpp"
#include "fem/element.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

/// A 3x3 block, column by column, N/m; the fourth lane means nothing. The alignment is said, for
/// the compiler's own differs between a body for AVX2 and one for any machine.
struct alignas(32) block3 {
  std::array<double4, 3> column{};
};

TEDIT_INLINE double4 in_lanes(const vec3& v) {
  return *reinterpret_cast<const double4_anywhere*>(&v);
}

/// Gathers rows; `gradients_at(e)` gives the gradients of an element.
class row_gatherer {
public:
  row_gatherer(const problem& p, const incidence& corners)
      : p_(p), corners_(corners), per_(static_cast<std::uint32_t>(p.nodes_per_element)) {}

  /// The other corners of a node's elements, ascending, each once; valid until the next call.
  std::span<const std::uint32_t> columns(std::size_t row) {
    const auto around = corners_.of_node(row);
    table_.start(4 * around.size());
    columns_.clear();
    for (const auto corner : around) {
      const auto* nodes = &p_.element_nodes[std::size_t{corner / per_} * per_];
      for (int b = 0; b < 4; ++b)
        if (nodes[b] != row && table_.at(nodes[b]).second)
          columns_.push_back(nodes[b]);
    }
    std::ranges::sort(columns_);
    return columns_;
  }

  /// Writes the values of a row whose columns stand in their place.
  template <class Gradients>
  TEDIT_INLINE void write(std::size_t row, const Gradients& gradients_at, block_matrix& k) {
    const auto columns = k.places.of(row, k.column);
    table_.start(columns.size() + 1);
    for (std::uint32_t i = 0; i < columns.size(); ++i)
      *table_.at(columns[i]).first = i;
    blocks_.assign(columns.size(), block3{});
    for (const auto corner : corners_.of_node(row))
      add_element(gradients_at(corner / per_), corner);
    std::size_t at = k.begin(row);
    for (const auto& block : blocks_) {
      split_block({__builtin_convertvector(block.column[0], float4),
                   __builtin_convertvector(block.column[1], float4),
                   __builtin_convertvector(block.column[2], float4)},
                  k.high[at], k.low[at]);
      ++at;
    }
  }

private:
  /// Adds the blocks between a corner of an element and its others.
  TEDIT_INLINE void add_element(const tet_gradients& g, std::uint32_t corner) {
    const std::size_t e = corner / per_;
    const std::size_t a = corner % per_;
    const auto [lambda, mu] = p_.constants[p_.element_materials[e]];
    const vec3 ga = g.gradient[a];
    const double4 va = g.volume * in_lanes(g.gradient[a]);
    for (std::size_t b = 0; b < 4; ++b) {
      if (b == a)
        continue;
      const vec3 gb = g.gradient[b];
      const double4 vb = g.volume * in_lanes(g.gradient[b]);
      const double both = g.volume * mu * dot(ga, gb);
      auto& k = blocks_[*table_.at(p_.element_nodes[per_ * e + b]).first].column;
      k[0] += lambda * gb.x * va + mu * ga.x * vb + double4{both, 0, 0, 0};
      k[1] += lambda * gb.y * va + mu * ga.y * vb + double4{0, both, 0, 0};
      k[2] += lambda * gb.z * va + mu * ga.z * vb + double4{0, 0, both, 0};
    }
  }

  const problem& p_;
  const incidence& corners_;
  const std::uint32_t per_;
  column_table table_;
  std::vector<std::uint32_t> columns_;
  std::vector<block3> blocks_;
};

/// Gradients of the elements that were asked for last: the rows around an element follow closely,
/// and an array of them all would be larger than the matrix.
class recent_gradients {
public:
  explicit recent_gradients(const problem& p) : p_(p), slots_(slot_count) {}

  TEDIT_INLINE const tet_gradients& of(std::size_t e) {
    auto& kept = slots_[e % slot_count];
    if (kept.element != e) {
      kept.element = e;
      kept.value = gradients_of(p_, e);
    }
    return kept.value;
  }

private:
  static constexpr std::size_t slot_count = 4096;  // Half a second-level cache.
  struct slot {
    std::size_t element = static_cast<std::size_t>(-1);
    tet_gradients value;
  };

  const problem& p_;
  std::vector<slot> slots_;
};

/// Makes room for the values of all entries that there are places for.
void fit_values(block_matrix& k) {
  for (auto* part : {&k.high, &k.low}) {
    part->resize(k.places.room() + block_matrix::padding);
    std::fill(part->end() - block_matrix::padding, part->end(), half_block{});
  }
}

/// The places of all rows and their columns; no values.
block_matrix make_pattern(const problem& p, const incidence& corners) {
  const std::size_t rows = p.corner_count;
  std::vector<std::uint32_t> length(rows);
  std::vector<std::vector<std::uint32_t>> columns(chunk_count(rows));
  parallel_for(rows, [&](std::size_t first, std::size_t last, std::size_t chunk) {
    row_gatherer gatherer(p, corners);
    for (std::size_t row = first; row < last; ++row) {
      const auto found = gatherer.columns(row);
      length[row] = static_cast<std::uint32_t>(found.size());
      columns[chunk].insert(columns[chunk].end(), found.begin(), found.end());
    }
  });
  block_matrix k;
  k.places = row_places(length);
  reserve_for_edits(k.column, k.places.room());
  polled_for(
    columns.size(),
    [&](std::size_t chunk) {
      k.column.insert(k.column.end(), columns[chunk].begin(), columns[chunk].end());
    },
    16);
  return k;
}

}  // namespace

block_matrix assemble_blocks(const problem& p, const incidence& corners) {
  auto k = make_pattern(p, corners);
  reserve_for_edits(k.high, k.places.room());
  reserve_for_edits(k.low, k.places.room());
  fit_values(k);
  parallel_for(p.corner_count, [&](std::size_t first, std::size_t last, std::size_t) {
    row_gatherer gatherer(p, corners);
    recent_gradients gradients(p);
    run_widest([&]() TEDIT_INLINED {
      const auto gradients_at = [&](std::size_t e)
                                  TEDIT_INLINED -> const tet_gradients& { return gradients.of(e); };
      for (std::size_t row = first; row < last; ++row)
        gatherer.write(row, gradients_at, k);
    });
  });
  return k;
}

void update_blocks(const problem& p, const incidence& corners, std::span<const std::uint32_t> nodes,
                   block_matrix& k) {
  row_gatherer gatherer(p, corners);
  while (k.rows() < p.corner_count)
    k.places.add(0);
  run_widest([&]() TEDIT_INLINED {
    const auto gradients_at = [&](std::size_t e) TEDIT_INLINED { return gradients_of(p, e); };
    for (const auto row : nodes) {
      if (row >= p.corner_count)
        continue;
      const auto columns = gatherer.columns(row);
      const auto at = k.places.replace(row, static_cast<std::uint32_t>(columns.size()));
      k.column.resize(k.places.room());
      fit_values(k);
      std::ranges::copy(columns, k.column.begin() + at);
      gatherer.write(row, gradients_at, k);
    }
  });
}

std::array<float, 6> diagonal_block(const block_matrix& k, std::size_t row) {
  constexpr std::array<int, 6> at{0, 3, 6, 4, 7, 8};
  std::array<double, 6> sum{};
  for (auto i = k.begin(row); i < k.end(row); ++i) {
    const auto block = k.block(i);
    for (int c = 0; c < 6; ++c)
      sum[c] -= static_cast<double>(block[at[c]]);
  }
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

namespace {

/// Of a symmetric matrix, upper triangle.
std::array<float, 6> invert_symmetric(const std::array<float, 6>& of) {
  std::array<double, 6> m;
  std::ranges::copy(of, m.begin());
  const double xx = m[3] * m[5] - m[4] * m[4];
  const double xy = m[2] * m[4] - m[1] * m[5];
  const double xz = m[1] * m[4] - m[2] * m[3];
  const double scale = 1 / (m[0] * xx + m[1] * xy + m[2] * xz);
  const auto entry = [&](double cofactor) { return static_cast<float>(scale * cofactor); };
  return {entry(xx),
          entry(xy),
          entry(xz),
          entry(m[0] * m[5] - m[2] * m[2]),
          entry(m[1] * m[2] - m[0] * m[4]),
          entry(m[0] * m[3] - m[1] * m[1])};
}

}  // namespace

std::array<float, 6> invert_block(const std::array<float, 6>& diagonal,
                                  const std::array<double, 6>& filter) {
  if (filter == std::array<double, 6>{1, 0, 0, 1, 0, 1} && diagonal[0] > 0)
    return invert_symmetric(diagonal);
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
  std::vector<std::array<float, 6>> result;
  polled_resize(result, diagonal.size());
  parallel_for(diagonal.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      result[n] = invert_block(diagonal[n], filter[n]);
  });
  return result;
}

}  // namespace tedit::fem
