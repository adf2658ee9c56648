// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "fem/kernels.hpp"
#include "fem/multilevel/energy_bound.hpp"
#include "fem/native/held_nodes.hpp"
#include "fem/native/vectors.hpp"
#include "fem/polled.hpp"

namespace tedit::fem::native {

/// Conjugate gradients in single precision within the free directions (MPCG, Baraff & Witkin 1998;
/// the filter as a projection on both sides: Ascher & Boxerman 2003). The preconditioner filters,
/// and so is the residual: reactions that pile up in its held parts would meet the rounding errors
/// of z there, and r.z turned negative after six digits.
///
/// Every case has its own step lengths and its own end: one that is done takes steps of length zero
/// from then on.
template <class L>
class krylov_solver {
public:
  /// `held` must outlive this.
  krylov_solver(std::size_t nodes, const held_nodes& held) : held_(held) { fit(nodes); }

  /// For an operator that has other rows now.
  void fit(std::size_t nodes) {
    for (auto* v : {&x_, &r_, &z_, &p_, &q_})
      polled_resize(*v, L::size(nodes));
  }

  /// Solves K x = residual for each of at most `L::width` cases until its residual has fallen by
  /// its reduction; `precondition(r, z)` writes z = B r. Contract: `linear_system::solve_many`.
  /// `smallest` is a lower bound of the eigenvalues of B K; it comes back sharper.
  template <class Operator, class Precondition>
  expected<void> solve(const Operator& k, const Precondition& precondition,
                       std::span<const inner_case> cases, int max_iterations, const execution& run,
                       double& smallest, std::span<inner_result> results) {
    begin(cases, results);
    bounds_.assign(cases.size(), energy_bound(smallest));
    rr_ = dots_of<L>(r_, r_);
    start_rr_ = rr_;
    precondition(r_.data(), z_.data());
    std::ranges::copy(z_, p_.begin());
    rz_ = dots_of<L>(r_, z_);
    start_ = rz_;
    for (std::size_t c = 0; c < cases.size(); ++c) {
      results[c].broke_down = !(rz_[c] >= 0);
      if (is_done(c))
        finish(c);
    }
    for (int i = 0; i < max_iterations && any_running(); ++i) {
      if (run.cancel.cancelled())
        return fail(ec::cancelled, "the solve was cancelled");
      step(k, precondition);
    }
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (running_[c])
        finish(c);
    for (const auto& bound : bounds_)
      smallest = sharper_bound(smallest, bound);
    write(0, cases.size());
    return {};
  }

  [[nodiscard]] std::uint64_t bytes() const { return 5 * x_.size() * sizeof(float); }

private:
  void begin(std::span<const inner_case> cases, std::span<inner_result> results) {
    cases_ = cases;
    results_ = results;
    running_ = {};
    written_ = {};
    std::fill_n(running_.begin(), cases.size(), true);
    std::ranges::fill(results, inner_result{});
    std::ranges::fill(r_, 0.0F);
    parallel_for(cases[0].residual.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t c = 0; c < cases.size(); ++c)
        for (std::size_t i = first; i < last; ++i)
          r_[L::width * i + c] = static_cast<float>(cases[c].residual[i]);
    });
    std::ranges::fill(x_, 0.0F);
    filter_held<L>(held_, r_.data());
  }

  template <class Operator, class Precondition>
  void step(const Operator& k, const Precondition& precondition) {
    const auto bend = multiply_direction(k);
    std::array<float, L::width> factor{};
    for (std::size_t c = 0; c < L::width; ++c) {
      if (!running_[c])
        continue;
      if (bend[c] > 0) {
        factor[c] = static_cast<float>(rz_[c] / bend[c]);
        bounds_[c].advance(rz_[c] / bend[c], rz_[c]);
        ++results_[c].iterations;
        continue;
      }
      results_[c].broke_down = true;
      finish(c);
    }
    if (!any_running())
      return;
    filter_held<L>(held_, q_.data());
    rr_ = advance(factor);
    precondition(r_.data(), z_.data());
    const auto next = dots_of<L>(r_, z_);
    for (std::size_t c = 0; c < L::width; ++c) {
      if (!running_[c])
        continue;
      results_[c].broke_down = !(next[c] >= 0);
      if (!results_[c].broke_down) {  // Else `rz_` stays the last one that meant something.
        factor[c] = static_cast<float>(next[c] / rz_[c]);
        bounds_[c].turn(next[c] / rz_[c]);
        rz_[c] = next[c];
      }
      if (is_done(c))
        finish(c);
    }
    if (any_running())
      turn(factor);
  }

  [[nodiscard]] bool any_running() const {
    return std::ranges::find(running_, true) != running_.end();
  }

  [[nodiscard]] bool is_done(std::size_t c) const {
    const auto& goal = cases_[c];
    const auto& bound = bounds_[c];
    return results_[c].broke_down || !(rz_[c] > goal.reduction * goal.reduction * start_[c]) ||
           rr_[c] <= goal.residual_reduction * goal.residual_reduction * start_rr_[c] ||
           bound.left(rz_[c]) <=
             std::max(goal.energy * goal.energy, goal.share * goal.share * bound.gained());
  }

  void finish(std::size_t c) {
    running_[c] = false;
    const double start = start_[c];
    results_[c].recurrence_reduction = start > 0 ? std::sqrt(rz_[c] / start) : start == 0 ? 0 : 1;
    results_[c].energy = std::sqrt(std::max(bounds_[c].left(rz_[c]), 0.0));
    results_[c].gained = bounds_[c].gained();
    if (!results_[c].broke_down)
      return;
    // Numbers that are not finite would stay in all steps to come.
    write(c, c + 1);
    written_[c] = true;
    for (auto* v : {&x_, &r_, &z_, &p_, &q_})
      for (std::size_t i = c; i < v->size(); i += L::width)
        (*v)[i] = 0;
  }

  /// Writes the corrections of the cases [first, last).
  void write(std::size_t first_case, std::size_t last_case) {
    const std::size_t unknowns = cases_[first_case].correction.size();
    parallel_for(unknowns, [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t c = first_case; c < last_case; ++c)
        if (!written_[c])
          for (std::size_t i = first; i < last; ++i)
            cases_[c].correction[i] = static_cast<double>(x_[L::width * i + c]);
    });
  }

  /// q = K p; returns p.q.
  template <class Operator>
  case_sums<L> multiply_direction(const Operator& k) {
    return for_rows<L>(k, p_.data(),
                       [this](std::size_t i, const typename L::node& row) TEDIT_INLINED {
                         L::store(row, q_.data(), i);
                         return L::dot(L::load(p_.data(), i), row);
                       });
  }

  /// One step along p; returns r.r.
  case_sums<L> advance(const std::array<float, L::width>& factor) {
    return sum_lanes<L>(x_.size() / L::width, [&](std::size_t first, std::size_t last,
                                                  typename L::sum& sum) TEDIT_INLINED {
      const auto alpha = L::load_scalar(factor.data(), 0);
      float* x = x_.data();
      float* r = r_.data();
      for (std::size_t i = first; i < last; ++i) {
        L::store_scalar(L::load_scalar(x, i) + alpha * L::load_scalar(p_.data(), i), x, i);
        const auto left = L::load_scalar(r, i) - alpha * L::load_scalar(q_.data(), i);
        L::store_scalar(left, r, i);
        L::add_product(left, left, sum);
      }
    });
  }

  void turn(const std::array<float, L::width>& factor) {
    for_lanes<L>(x_.size() / L::width, [&](std::size_t first, std::size_t last) TEDIT_INLINED {
      const auto beta = L::load_scalar(factor.data(), 0);
      float* p = p_.data();
      for (std::size_t i = first; i < last; ++i)
        L::store_scalar(L::load_scalar(z_.data(), i) + beta * L::load_scalar(p, i), p, i);
    });
  }

  const held_nodes& held_;
  std::vector<float> x_, r_, z_, p_, q_;  ///< Correction, residual, B r, direction, K p.

  std::span<const inner_case> cases_;
  std::span<inner_result> results_;
  std::array<bool, L::width> running_{};
  std::array<bool, L::width> written_{};
  case_sums<L> rz_{}, rr_{}, start_{}, start_rr_{};  ///< r.B r, r.r; at first.
  std::vector<energy_bound> bounds_;
};

}  // namespace tedit::fem::native
