// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "fem/kernels.hpp"
#include "fem/native/vectors.hpp"

namespace tedit::fem {

/// Conjugate gradients in single precision within the free directions (MPCG, Baraff & Witkin 1998;
/// the filter as a projection on both sides: Ascher & Boxerman 2003). The preconditioner filters,
/// and so is the residual: reactions that pile up in its held parts would meet the rounding errors
/// of z there, and r.z turned negative after six digits.
class conjugate_gradients {
public:
  explicit conjugate_gradients(std::size_t nodes) { resize(nodes); }

  void resize(std::size_t nodes) {
    for (auto* v : {&x_, &r_, &z_, &p_, &q_})
      v->assign(padded3(nodes), 0);
  }

  /// S of every node, for the residual.
  void set_filter(filter_span filter) {
    held_.clear();
    for (std::uint32_t n = 0; n < filter.size(); ++n)
      if (filter[n] != std::array<double, 6>{1, 0, 0, 1, 0, 1}) {
        auto& [node, s] = held_.emplace_back(n, std::array<float, 6>{});
        std::ranges::transform(filter[n], s.begin(),
                               [](double v) { return static_cast<float>(v); });
      }
  }

  /// Solves K x = residual until the preconditioned residual has fallen by `reduction`;
  /// `precondition(r, z)` writes z = B r. Contract: `linear_system::solve`.
  template <class Operator, class Precondition>
  expected<inner_result> solve(const Operator& k, Precondition&& precondition,
                               std::span<const double> residual, std::span<double> correction,
                               double reduction, int max_iterations, const execution& run) {
    begin(residual);
    inner_result result;
    precondition(r_.data(), z_.data());
    p_ = z_;
    double rz = dot_of(r_, z_);
    const double start = rz;
    if (rz == 0)
      result.recurrence_reduction = 0;
    result.broke_down = !(rz >= 0);
    while (!result.broke_down && result.iterations < max_iterations &&
           rz > reduction * reduction * start) {
      if (run.cancel.cancelled())
        return fail(ec::cancelled, "the solve was cancelled");
      const double bend = multiply_direction(k);
      if (!(bend > 0)) {
        result.broke_down = true;
        break;
      }
      advance(static_cast<float>(rz / bend));
      ++result.iterations;
      precondition(r_.data(), z_.data());
      const double next = dot_of(r_, z_);
      if (!(next >= 0)) {
        result.broke_down = true;
        break;  // `rz` stays the last one that meant something.
      }
      turn(static_cast<float>(next / rz));
      rz = next;
    }
    std::transform(x_.begin(), x_.end() - 1, correction.begin(),
                   [](float v) { return static_cast<double>(v); });
    if (start > 0)
      result.recurrence_reduction = std::sqrt(rz / start);
    return result;
  }

  [[nodiscard]] std::uint64_t bytes() const { return 5 * x_.size() * sizeof(float); }

private:
  void begin(std::span<const double> residual) {
    std::ranges::transform(residual, r_.begin(), [](double v) { return static_cast<float>(v); });
    std::ranges::fill(x_, 0.0F);
    filter_residual();
  }

  void filter_residual() {
    for (const auto& [node, s] : held_) {
      float* r = &r_[3 * std::size_t{node}];
      store3(multiply_symmetric(s, load4(r)), r);
    }
  }

  /// q = K p; returns p.q.
  template <class Operator>
  double multiply_direction(const Operator& k) {
    return for_rows(k, p_.data(), [this](std::size_t i, float4 row) {
      store3(row, &q_[3 * i]);
      const float4 d = load4(&p_[3 * i]) * row;
      return d[0] + d[1] + d[2];
    });
  }

  void advance(float alpha) {
    parallel_for(x_.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) {
        x_[i] += alpha * p_[i];
        r_[i] -= alpha * q_[i];
      }
    });
    filter_residual();
  }

  void turn(float beta) {
    parallel_for(x_.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i)
        p_[i] = z_[i] + beta * p_[i];
    });
  }

  std::vector<std::pair<std::uint32_t, std::array<float, 6>>> held_;  ///< Nodes that are not free.
  std::vector<float> x_, r_, z_, p_, q_;  ///< Correction, residual, B r, direction, K p.
};

}  // namespace tedit::fem
