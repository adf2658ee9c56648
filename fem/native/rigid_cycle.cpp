// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/rigid_cycle.hpp"

#include <algorithm>

#include "fem/native/rigid_six.hpp"

namespace tedit::fem::native {

namespace {

/// Calls visit(column, block) for the entries of row i, the diagonal included.
template <class Visit>
TEDIT_INLINE void for_blocks(const rigid_level& level, std::size_t i, const Visit& visit) {
  for (auto s = level.rows.begin(i), end = level.rows.end(i); s < end; ++s)
    visit(std::size_t{level.column[s]}, level.block[s]);
}

/// Calls visit(parent, block) for the entries of row i of the prolongation to the next level.
template <class Visit>
TEDIT_INLINE void for_parents(const rigid_level& level, std::size_t i, const Visit& visit) {
  for (auto s = level.prolongation_rows.begin(i), end = level.prolongation_rows.end(i); s < end;
       ++s)
    visit(std::size_t{level.prolongation_column[s]}, level.prolongation[s]);
}

/// Calls sink(i, row i of A x) for all rows.
template <class L, class Sink>
void for_rigid_rows(const rigid_level& level, const float* x, const Sink& sink) {
  using six = rigid_six<L>;
  for_lanes<L>(
    level.nodes(),
    [&](std::size_t first, std::size_t last) TEDIT_INLINED {
      for (std::size_t i = first; i < last; ++i) {
        six sum;
        for_blocks(level, i, [&](std::size_t column, const auto& block) TEDIT_INLINED {
          sum.add_product(block, x, column);
        });
        sink(i, sum);
      }
    },
    rigid_chunk);
}

/// block * x.
template <class L>
TEDIT_INLINE rigid_six<L> product(const rigid_level::block6& block, const rigid_six<L>& x) {
  rigid_six<L> result;
  result.add_product(block, x);
  return result;
}

/// Rows of which a restriction keeps sums of their own: fixed, so that its bits do not depend on
/// the number of threads, and few, for each part costs as much as a vector of the next level.
std::size_t restriction_part(std::size_t rows) {
  return std::max<std::size_t>(2048, (rows + 7) / 8);
}

/// down = P^T fine, to the next level. Row by row of P, whose blocks are then read in their order,
/// into sums of the next level, which fit into the nearest cache: by columns each block was a miss,
/// and the restriction took a quarter of a solve.
template <class L>
void restrict_rigid(const rigid_level& a, const float* fine, std::span<float> down,
                    std::vector<float>& partial) {
  const std::size_t rows = a.nodes();
  const std::size_t part = restriction_part(rows);
  const std::size_t parts = (rows + part - 1) / part;
  partial.assign(parts * down.size(), 0);
  for_lanes<L>(
    rows,
    [&](std::size_t first, std::size_t last) TEDIT_INLINED {
      float* to = &partial[first / part * down.size()];
      for (std::size_t i = first; i < last; ++i) {
        const auto x = rigid_six<L>::load(fine, i);
        for_parents(a, i, [&](std::size_t parent, const auto& block) TEDIT_INLINED {
          auto sum = rigid_six<L>::load(to, parent);
          sum.add_transposed(block, x);
          sum.store(to, parent);
        });
      }
    },
    part);
  for_lanes<L>(down.size(), [&](std::size_t first, std::size_t last) TEDIT_INLINED {
    for (std::size_t i = first; i < last; ++i) {
      float sum = 0;
      for (std::size_t p = 0; p < parts; ++p)
        sum += partial[p * down.size() + i];
      down[i] = sum;
    }
  });
}

/// fine = P up.
template <class L>
void prolongate_rigid(const rigid_level& a, const float* up, float* fine) {
  for_lanes<L>(
    a.nodes(),
    [&](std::size_t first, std::size_t last) TEDIT_INLINED {
      for (std::size_t i = first; i < last; ++i) {
        rigid_six<L> sum;
        for_parents(a, i, [&](std::size_t parent, const auto& block) TEDIT_INLINED {
          sum.add_product(block, up, parent);
        });
        sum.store(fine, i);
      }
    },
    rigid_chunk);
}

}  // namespace

template <class L>
rigid_cycle<L>::rigid_cycle(const hierarchy& h, const cycle_settings& settings)
    : h_(h), settings_(settings) {
  fit();
}

template <class L>
void rigid_cycle<L>::fit() {
  work_.resize(h_.levels.size());
  for (std::size_t l = 0; l < work_.size(); ++l)
    for (auto* v :
         {&work_[l].residual, &work_[l].step, &work_[l].other, &work_[l].down, &work_[l].up})
      v->resize(6 * L::width * h_.levels[l].nodes(), 0);
}

template <class L>
void rigid_cycle<L>::solve(std::size_t level, std::span<const float> right,
                           std::span<float> result) {
  if (level + 1 == h_.levels.size()) {
    solve_coarsest(right, result);
    return;
  }
  smooth_from_zero(level, right, result);
  for (int visit = 0; visit < settings_.repeats; ++visit)
    correct(level, result);
}

/// The factors are scalar: each case for itself, and a case that is done costs nothing.
template <class L>
void rigid_cycle<L>::solve_coarsest(std::span<const float> right, std::span<float> result) const {
  if constexpr (L::width == 1) {
    h_.coarsest->solve(right, result);
  } else {
    const auto lane = [&](std::size_t c) {
      std::vector<float> own(right.size() / L::width);
      for (std::size_t i = 0; i < own.size(); ++i)
        own[i] = right[L::width * i + c];
      if (std::ranges::any_of(own, [](float v) { return v != 0; }))
        h_.coarsest->solve(own, own);
      for (std::size_t i = 0; i < own.size(); ++i)
        result[L::width * i + c] = own[i];
    };
    parallel_for(
      L::width, [&](std::size_t first, std::size_t, std::size_t) { lane(first); }, 1);
  }
}

template <class L>
void rigid_cycle<L>::move(std::size_t level, chebyshev_weights c, float enter, float* z) {
  using six = rigid_six<L>;
  const auto& a = h_.levels[level];
  auto& w = work_[level];
  float* residual = w.residual.data();
  const float* step = w.step.data();
  float* next = w.other.data();
  for_rigid_rows<L>(a, step, [&](std::size_t i, const six& row) TEDIT_INLINED {
    const six left = six::load(residual, i) - row;
    left.store(residual, i);
    const six old = six::load(step, i);
    const six now = c.before * old + c.fresh * product<L>(a.inverse[i], left);
    now.store(next, i);
    (six::load(z, i) + (enter * old + now)).store(z, i);
  });
  w.step.swap(w.other);
}

template <class L>
void rigid_cycle<L>::smooth_from_zero(std::size_t level, std::span<const float> right,
                                      std::span<float> z) {
  using six = rigid_six<L>;
  const auto& a = h_.levels[level];
  auto& w = work_[level];
  std::ranges::copy(right, w.residual.begin());
  for_lanes<L>(
    a.nodes(),
    [&](std::size_t first, std::size_t last) TEDIT_INLINED {
      for (std::size_t i = first; i < last; ++i)
        (chebyshev_start(a.lambda) * product<L>(a.inverse[i], six::load(right.data(), i)))
          .store(w.step.data(), i);
    },
    rigid_chunk);
  std::ranges::copy(w.step, z.begin());
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(level, chebyshev_step(k, a.lambda), 0, z.data());
}

template <class L>
void rigid_cycle<L>::correct(std::size_t level, std::span<float> z) {
  using six = rigid_six<L>;
  const auto& a = h_.levels[level];
  auto& w = work_[level];
  for_rigid_rows<L>(a, w.step.data(), [&](std::size_t i, const six& row) TEDIT_INLINED {
    (six::load(w.residual.data(), i) - row).store(w.residual.data(), i);
  });
  auto& coarser = work_[level + 1];
  restrict_rigid<L>(a, w.residual.data(), coarser.down, partial_);
  solve(level + 1, coarser.down, coarser.up);
  prolongate_rigid<L>(a, coarser.up.data(), w.step.data());

  move(level, {0, chebyshev_start(a.lambda)}, 1, z.data());
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(level, chebyshev_step(k, a.lambda), 0, z.data());
}

template class rigid_cycle<one_case>;
template class rigid_cycle<cases_of<4>>;
template class rigid_cycle<cases_of<8>>;

}  // namespace tedit::fem::native
