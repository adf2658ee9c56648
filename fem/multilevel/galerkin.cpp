// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/galerkin.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "base/guard.hpp"
#include "base/parallel.hpp"

namespace tedit::fem {

bool is_held(const std::array<double, 6>& s) {
  return s[0] + s[3] + s[5] < 1e-9;
}

bool is_free(const std::array<double, 6>& s) {
  return s[0] + s[3] + s[5] > 3 - 1e-9;
}

float block_norm(const block_matrix& k, std::uint32_t entry) {
  float sum = 0;
  for (const float v : k.block(entry))
    sum += v * v;
  return std::sqrt(sum);
}

float coupling_scale(const block_matrix& k, std::size_t row) {
  const auto d = diagonal_block(k, row);
  const float square =
    d[0] * d[0] + d[3] * d[3] + d[5] * d[5] + 2 * (d[1] * d[1] + d[2] * d[2] + d[4] * d[4]);
  return square > 0 ? 1 / std::sqrt(std::sqrt(square)) : 0;
}

rigid_frame frame_of(const problem& p, std::span<const std::uint32_t> nodes) {
  rigid_frame frame;
  const auto count = static_cast<double>(nodes.size());
  for (const auto n : nodes)
    frame.centre += p.nodes[n] / count;
  double square = 0;
  for (const auto n : nodes)
    square += dot(p.nodes[n] - frame.centre, p.nodes[n] - frame.centre) / count;
  frame.radius = square > 0 ? std::sqrt(square) : 1;
  return frame;
}

void store_transfer(const problem& p, filter_span filter, const rigid_frame& frame,
                    std::uint32_t node, hierarchy& h) {
  const vec3 arm = (p.nodes[node] - frame.centre) / frame.radius;
  h.arm[node] = {static_cast<float>(arm.x), static_cast<float>(arm.y), static_cast<float>(arm.z)};
  if (h.filter.empty() && is_free(filter[node]))
    return;
  h.filter.resize(h.arm.size(), {1, 0, 0, 1, 0, 1});
  std::ranges::transform(filter[node], h.filter[node].begin(),
                         [](double s) { return static_cast<float>(s); });
}

namespace {

/// A 3x3 block, column by column; the fourth lane means nothing.
using columns3 = std::array<double4, 3>;

TEDIT_INLINE double4 turned(double4 v) {
  return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}

TEDIT_INLINE double4 cross(double4 a, double4 b) {
  return turned(a * turned(b) - turned(a) * b);
}

/// block * v.
TEDIT_INLINE double4 product(const columns3& block, double4 v) {
  return block[0] * v[0] + block[1] * v[1] + block[2] * v[2];
}

TEDIT_INLINE columns3 symmetric(const std::array<float, 6>& s) {
  return {__builtin_convertvector(float4{s[0], s[1], s[2]}, double4),
          __builtin_convertvector(float4{s[1], s[3], s[4]}, double4),
          __builtin_convertvector(float4{s[2], s[4], s[5]}, double4)};
}

/// One row of P^T K P, and the projector onto the motions that its aggregate has.
struct galerkin_row {
  std::vector<std::uint32_t> column;  ///< Ascending.
  std::vector<matrix6> block;
  matrix6 keep;
};

/// Makes rows; for code inside `run_widest`.
class row_maker {
public:
  row_maker(const block_matrix& k, const hierarchy& h) : k_(k), h_(h) {}

  TEDIT_INLINE galerkin_row make(std::uint32_t a) {
    galerkin_row row;
    row_sum::block gram;
    gram.fill(0);
    for (const auto n : h_.members.of(a))
      add_node(n, gram);
    row.keep = remove_null_motions(row_sum::view(gram.data()), sum_.matrix_at(a));
    sum_.finish(row.column, row.block);
    return row;
  }

private:
  /// K_ij summed over the nodes j of one aggregate, each times its motions S [I, -[arm]x]: six
  /// columns. The alignment is said, for the compiler's own differs between bodies.
  struct alignas(32) part {
    std::array<double4, 6> column;
    std::uint32_t aggregate;
  };

  TEDIT_INLINE double4 arm(std::uint32_t n) const {
    const auto& d = h_.arm[n];
    return __builtin_convertvector(float4{d[0], d[1], d[2]}, double4);
  }

  TEDIT_INLINE void add_node(std::uint32_t i, row_sum::block& gram) {
    const double4 own = arm(i);
    parts_.clear();
    columns3 diagonal{};
    for (auto s = k_.begin(i); s < k_.end(i); ++s) {
      const exact_values values(k_, s);
      const columns3 block{__builtin_convertvector(column<0>(values), double4),
                           __builtin_convertvector(column<1>(values), double4),
                           __builtin_convertvector(column<2>(values), double4)};
      for (std::size_t c = 0; c < 3; ++c)
        diagonal[c] -= block[c];
      if (const auto j = k_.column[s]; h_.aggregate[j] != no_id)
        add_motions(block, j, part_of(h_.aggregate[j]).column);
    }
    add_motions(diagonal, i, part_of(h_.aggregate[i]).column);
    for (const auto& p : parts_)
      add_transposed(i, own, p.column, sum_.at(p.aggregate));
    std::array<double4, 6> motions{};
    add_motions({double4{1, 0, 0}, double4{0, 1, 0}, double4{0, 0, 1}}, i, motions);
    add_transposed(i, own, motions, gram);
  }

  part& part_of(std::uint32_t aggregate) {
    const auto found = std::ranges::find(parts_, aggregate, &part::aggregate);
    return found != parts_.end() ? *found : parts_.emplace_back(part{{}, aggregate});
  }

  /// to += block S [I, -[arm]x] of node j.
  TEDIT_INLINE void add_motions(columns3 block, std::uint32_t j, std::array<double4, 6>& to) const {
    if (!h_.filter.empty()) {
      const auto s = symmetric(h_.filter[j]);
      block = {product(block, s[0]), product(block, s[1]), product(block, s[2])};
    }
    const double4 d = arm(j);
    for (std::size_t c = 0; c < 3; ++c)
      to[c] += block[c];
    to[3] += d[1] * block[2] - d[2] * block[1];
    to[4] += d[2] * block[0] - d[0] * block[2];
    to[5] += d[0] * block[1] - d[1] * block[0];
  }

  /// to += (S [I, -[arm]x])^T columns of node i: below S v comes arm x S v.
  TEDIT_INLINE void add_transposed(std::uint32_t i, double4 own, std::array<double4, 6> columns,
                                   row_sum::block& to) const {
    if (!h_.filter.empty())
      for (auto& v : columns)
        v = product(symmetric(h_.filter[i]), v);
    unrolled<6>([&](auto c) TEDIT_INLINED {
      const double4 v = columns[c];
      const double4 moment = cross(own, v);
      auto* at = reinterpret_cast<double4_anywhere*>(&to[8 * c]);
      at[0] += __builtin_shufflevector(v, moment, 0, 1, 2, 4);
      at[1] += __builtin_shufflevector(moment, double4{}, 1, 2, 4, 5);
    });
  }

  const block_matrix& k_;
  const hierarchy& h_;
  row_sum sum_;
  std::vector<part> parts_;
};

}  // namespace

void make_galerkin_rows(const block_matrix& k, std::span<const std::uint32_t> rows, hierarchy& h) {
  constexpr std::size_t at_once = 1024;  // Rows in double precision.
  auto& memory = h.memory->levels.front();
  auto& level = h.levels.front();
  memory.keep.resize(memory.frames.size(), matrix6::Identity());
  std::vector<galerkin_row> fresh;
  for (std::size_t start = 0; start < rows.size(); start += at_once) {
    const auto part = rows.subspan(start, std::min(at_once, rows.size() - start));
    fresh.resize(part.size());
    parallel_for(
      part.size(),
      [&](std::size_t first, std::size_t last, std::size_t) {
        row_maker rows_of(k, h);
        run_widest([&]() TEDIT_INLINED {
          for (std::size_t i = first; i < last; ++i)
            fresh[i] = rows_of.make(part[i]);
        });
      },
      8);
    check_cancelled();
    for (std::size_t i = 0; i < part.size(); ++i)
      memory.keep[part[i]] = fresh[i].keep;
    replace_rows(level, part, [&](std::size_t i) -> const galerkin_row& { return fresh[i]; });
  }
  renew_inverses(level, rows);
}

}  // namespace tedit::fem
