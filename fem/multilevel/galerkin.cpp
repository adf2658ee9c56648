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
  const float* v = &k.value[9 * std::size_t{entry}];
  float sum = 0;
  for (int i = 0; i < 9; ++i)
    sum += v[i] * v[i];
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

Eigen::Matrix3d symmetric(const std::array<double, 6>& s) {
  Eigen::Matrix3d m;
  m << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  return m;
}

/// One row of P^T K P, and the projector onto the motions that its aggregate has.
struct galerkin_row {
  std::vector<std::uint32_t> column;  ///< Ascending.
  std::vector<matrix6> block;
  matrix6 keep;
};

class row_maker {
public:
  row_maker(const problem& p, const block_matrix& k, filter_span filter, const hierarchy& h,
            std::span<const rigid_frame> frames)
      : p_(p), k_(k), filter_(filter), h_(h), frames_(frames) {}

  galerkin_row make(std::uint32_t a) {
    galerkin_row row;
    matrix6 gram = matrix6::Zero();
    for (const auto n : h_.members.of(a))
      add_node(n, gram);
    row.keep = remove_null_motions(gram, sum_.matrix_at(a));
    sum_.finish(row.column, row.block);
    return row;
  }

private:
  [[nodiscard]] matrix36 modes(std::uint32_t n) const {
    const auto& frame = frames_[h_.aggregate[n]];
    const matrix36 p = rigid_modes((p_.nodes[n] - frame.centre) / frame.radius);
    return is_free(filter_[n]) ? p : matrix36(symmetric(filter_[n]) * p);
  }

  /// K_ij summed over the nodes j of one aggregate, and times their motions.
  struct part {
    std::uint32_t aggregate;
    matrix36 product;
  };

  void add_node(std::uint32_t i, matrix6& gram) {
    const matrix36 own = modes(i);
    gram.noalias() += own.transpose() * own;
    parts_.clear();
    Eigen::Matrix3d diagonal = Eigen::Matrix3d::Zero();
    for (auto s = k_.begin(i); s < k_.end(i); ++s) {
      const Eigen::Matrix3d block =
        Eigen::Map<const Eigen::Matrix3f>(&k_.value[9 * std::size_t{s}]).cast<double>();
      diagonal -= block;
      if (const auto j = k_.column[s]; h_.aggregate[j] != no_id)
        add_motions(block, j, part_of(h_.aggregate[j]).product);
    }
    add_motions(diagonal, i, part_of(h_.aggregate[i]).product);
    for (const auto& p : parts_)
      sum_.matrix_at(p.aggregate).noalias() += own.transpose() * p.product;
  }

  part& part_of(std::uint32_t aggregate) {
    const auto found = std::ranges::find(parts_, aggregate, &part::aggregate);
    return found != parts_.end() ? *found : parts_.emplace_back(aggregate, matrix36::Zero());
  }

  /// to += block [I, -[arm]x], column by column: that of -[d]x b is b x d.
  void add_motions(const Eigen::Matrix3d& block, std::uint32_t j, matrix36& to) const {
    if (!is_free(filter_[j])) {
      to.noalias() += block * modes(j);
      return;
    }
    const auto& frame = frames_[h_.aggregate[j]];
    const vec3 d = (p_.nodes[j] - frame.centre) / frame.radius;
    to.leftCols<3>() += block;
    to.col(3) += d.y * block.col(2) - d.z * block.col(1);
    to.col(4) += d.z * block.col(0) - d.x * block.col(2);
    to.col(5) += d.x * block.col(1) - d.y * block.col(0);
  }

  const problem& p_;
  const block_matrix& k_;
  filter_span filter_;
  const hierarchy& h_;
  std::span<const rigid_frame> frames_;
  row_sum sum_;
  std::vector<part> parts_;
};

}  // namespace

void make_galerkin_rows(const problem& p, const block_matrix& k, filter_span filter,
                        std::span<const std::uint32_t> rows, hierarchy& h) {
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
        row_maker rows_of(p, k, filter, h, memory.frames);
        for (std::size_t i = first; i < last; ++i)
          fresh[i] = rows_of.make(part[i]);
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
