// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/cycle.hpp"

#include <Eigen/Core>

#include <algorithm>

namespace tedit::fem {

namespace {

using vector6 = Eigen::Matrix<float, 6, 1>;
using matrix6f = Eigen::Matrix<float, 6, 6>;

constexpr std::size_t rigid_chunk = 512;

Eigen::Map<const vector6> six(const float* x, std::size_t i) {
  return Eigen::Map<const vector6>(x + 6 * i);
}

Eigen::Map<vector6> six(float* x, std::size_t i) {
  return Eigen::Map<vector6>(x + 6 * i);
}

Eigen::Map<const matrix6f> matrix(const rigid_level::block6& block) {
  return Eigen::Map<const matrix6f>(block.data());
}

/// Calls sink(i, row i of A x) for all rows.
template <class Sink>
void for_rigid_rows(const rigid_level& level, const float* x, Sink&& sink) {
  parallel_for(
    level.nodes(),
    [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) {
        vector6 sum = vector6::Zero();
        for (auto s = level.rows.begin(i); s < level.rows.end(i); ++s)
          sum.noalias() += matrix(level.block[s]) * six(x, level.column[s]);
        sink(i, sum);
      }
    },
    rigid_chunk);
}

float4 filtered(const hierarchy& h, std::size_t n, float4 x) {
  return h.filter.empty() ? x : multiply_symmetric(h.filter[n], x);
}

}  // namespace

rigid_cycle::rigid_cycle(const hierarchy& h, const cycle_settings& settings)
    : h_(h), settings_(settings), work_(h.levels.size()) {
  for (std::size_t l = 0; l < work_.size(); ++l)
    for (auto* v : {&work_[l].residual, &work_[l].step, &work_[l].other, &work_[l].right,
                    &work_[l].correction})
      v->assign(std::size_t{6} * h.levels[l].nodes(), 0);
}

void rigid_cycle::solve(std::size_t level, std::span<const float> right, std::span<float> result) {
  if (level + 1 == h_.levels.size()) {
    h_.coarsest->solve(right, result);
    return;
  }
  once(level, right, result);
  auto& w = work_[level];
  for (int again = 1; again < settings_.repeats; ++again) {
    for_rigid_rows(h_.levels[level], result.data(), [&](std::size_t i, const vector6& row) {
      six(w.right.data(), i) = six(right.data(), i) - row;
    });
    once(level, w.right, w.correction);
    add_to(w.correction.data(), result.data(), result.size());
  }
}

void rigid_cycle::once(std::size_t level, std::span<const float> right, std::span<float> z) {
  const auto& a = h_.levels[level];
  auto& w = work_[level];
  const auto move = [&](chebyshev_weights c, float enter) {
    for_rigid_rows(a, w.step.data(), [&](std::size_t i, const vector6& row) {
      six(w.residual.data(), i) -= row;
      const vector6 old = six(w.step.data(), i);
      const vector6 now =
        c.before * old + c.fresh * (matrix(a.inverse[i]) * six(w.residual.data(), i));
      six(w.other.data(), i) = now;
      six(z.data(), i) += enter * old + now;
    });
    w.step.swap(w.other);
  };
  std::ranges::copy(right, w.residual.begin());
  for (std::size_t i = 0; i < a.nodes(); ++i)
    six(w.step.data(), i).noalias() =
      chebyshev_start(a.lambda) * (matrix(a.inverse[i]) * six(right.data(), i));
  std::ranges::copy(w.step, z.begin());
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(chebyshev_step(k, a.lambda), 0);
  for_rigid_rows(a, w.step.data(),
                 [&](std::size_t i, const vector6& row) { six(w.residual.data(), i) -= row; });

  const std::size_t parents = h_.levels[level + 1].nodes();
  std::vector<float> down(6 * parents, 0);
  std::vector<float> up(6 * parents, 0);
  for (std::size_t p = 0; p < parents; ++p)
    for (const auto entry : a.entries.of(p))
      six(down.data(), p).noalias() +=
        matrix(a.prolongation[entry]).transpose() * six(w.residual.data(), a.entry_row[entry]);
  solve(level + 1, down, up);
  std::ranges::fill(w.step, 0.0F);
  for (std::size_t i = 0; i < a.nodes(); ++i)
    for (auto s = a.prolongation_rows.begin(i); s < a.prolongation_rows.end(i); ++s)
      six(w.step.data(), i).noalias() +=
        matrix(a.prolongation[s]) * six(up.data(), a.prolongation_column[s]);

  move({0, chebyshev_start(a.lambda)}, 1);
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(chebyshev_step(k, a.lambda), 0);
}

multilevel_cycle::multilevel_cycle(const block_matrix& k, const hierarchy& h,
                                   const cycle_settings& settings)
    : k_(k),
      h_(h),
      settings_(settings),
      rigid_(h, settings),
      v_(k.rows()),
      coarse_right_(std::size_t{6} * h.levels.front().nodes()),
      coarse_(coarse_right_.size()) {}

void multilevel_cycle::apply(const float* right, float* z) {
  smooth_from_zero(k_, h_.smoother, settings_.node_degree, right, v_, z);
  restrict_residual();
  rigid_.solve(coarse_right_, coarse_);
  prolongate();
  smooth_correction(k_, h_.smoother, settings_.node_degree, v_, z);
}

void multilevel_cycle::restrict_residual() {
  parallel_for(
    h_.levels.front().nodes(),
    [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t a = first; a < last; ++a) {
        vector6 sum = vector6::Zero();
        for (const auto n : h_.members.of(a)) {
          const float4 f = filtered(h_, n, load4(&v_.residual[3 * std::size_t{n}]));
          const auto& d = h_.arm[n];
          sum += vector6(f[0], f[1], f[2], d[1] * f[2] - d[2] * f[1], d[2] * f[0] - d[0] * f[2],
                         d[0] * f[1] - d[1] * f[0]);
        }
        six(coarse_right_.data(), a) = sum;
      }
    },
    rigid_chunk);
}

/// The correction of the rigid levels, as a step.
void multilevel_cycle::prolongate() {
  parallel_for(k_.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      float4 u{};
      if (const auto a = h_.aggregate[n]; a != no_id) {
        const float* c = &coarse_[6 * std::size_t{a}];
        const auto& d = h_.arm[n];
        u = filtered(h_, n,
                     float4{c[0] + c[4] * d[2] - c[5] * d[1], c[1] + c[5] * d[0] - c[3] * d[2],
                            c[2] + c[3] * d[1] - c[4] * d[0], 0});
      }
      store3(u, &v_.step[3 * n]);
    }
  });
}

}  // namespace tedit::fem
