// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/cycle.hpp"

#include "fem/native/rigid_six.hpp"

namespace tedit::fem::native {

namespace {

template <class Node>
TEDIT_INLINE Node filtered(const hierarchy& h, std::size_t n, const Node& x) {
  return h.filter.empty() ? x : multiply_symmetric(h.filter[n], x);
}

}  // namespace

template <class L>
multilevel_cycle<L>::multilevel_cycle(const block_matrix& k, const hierarchy& h,
                                      const cycle_settings& settings)
    : k_(k), h_(h), settings_(settings), rigid_(h, settings), v_(k.rows()) {
  fit();
}

template <class L>
void multilevel_cycle<L>::fit() {
  rigid_.fit();
  v_.fit(k_.rows());
  coarse_right_.resize(6 * L::width * h_.levels.front().nodes());
  coarse_.resize(coarse_right_.size());
}

template <class L>
void multilevel_cycle<L>::apply(const float* right, float* z) {
  const smoothed_matrix k{k_, h_.exact_rows};
  smooth_from_zero<L>(k, h_.smoother, settings_.node_degree, right, v_, z);
  restrict_residual();
  rigid_.solve(coarse_right_, coarse_);
  prolongate();
  smooth_correction<L>(k, h_.smoother, settings_.node_degree, v_, z);
}

template <class L>
void multilevel_cycle<L>::restrict_residual() {
  for_lanes<L>(
    h_.levels.front().nodes(),
    [&](std::size_t first, std::size_t last) TEDIT_INLINED {
      for (std::size_t a = first; a < last; ++a) {
        rigid_six<L> sum;
        for (const auto n : h_.members.of(a)) {
          const auto f = filtered(h_, n, L::load(v_.residual.data(), n));
          const auto x = L::component(f, 0);
          const auto y = L::component(f, 1);
          const auto t = L::component(f, 2);
          const auto& d = h_.arm[n];
          sum.add(x, y, t, d[1] * t - d[2] * y, d[2] * x - d[0] * t, d[0] * y - d[1] * x);
        }
        sum.store(coarse_right_.data(), a);
      }
    },
    rigid_chunk);
}

/// The correction of the rigid levels, as a step.
template <class L>
void multilevel_cycle<L>::prolongate() {
  for_lanes<L>(k_.rows(), [&](std::size_t first, std::size_t last) TEDIT_INLINED {
    const auto coarse = [&](std::size_t a, std::size_t c)
                          TEDIT_INLINED { return L::load_scalar(coarse_.data(), 6 * a + c); };
    for (std::size_t n = first; n < last; ++n) {
      typename L::node u{};
      if (const std::size_t a = h_.aggregate[n]; a != no_id) {
        const auto& d = h_.arm[n];
        u = filtered(h_, n,
                     settings_.over_correction *
                       L::node_of(coarse(a, 0) + coarse(a, 4) * d[2] - coarse(a, 5) * d[1],
                                  coarse(a, 1) + coarse(a, 5) * d[0] - coarse(a, 3) * d[2],
                                  coarse(a, 2) + coarse(a, 3) * d[1] - coarse(a, 4) * d[0]));
      }
      L::store(u, v_.step.data(), n);
    }
  });
}

template class multilevel_cycle<one_case>;
template class multilevel_cycle<cases_of<4>>;
template class multilevel_cycle<cases_of<8>>;

}  // namespace tedit::fem::native
