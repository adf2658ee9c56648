// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>

#include "fem/multilevel/lanczos.hpp"

namespace tedit::fem {

/// Of the eigenvalues of B K with a multilevel cycle, before a solve has told more.
inline constexpr double usual_smallest = 0.1;

/// What is left of the error in the energy norm while preconditioned conjugate gradients run, from
/// their scalars alone: the Gauss-Radau upper bound of Meurant & Tichy 2013 (Numer. Algorithms 62,
/// section 4), for which a lower bound of the eigenvalues of B K must be known. r.Br itself is no
/// measure: errors that the preconditioner B hardly sees, as after an edit, are ten times larger.
class energy_bound {
public:
  energy_bound() = default;
  /// `smallest`: at most the smallest eigenvalue of B K.
  explicit energy_bound(double smallest) : smallest_(smallest), radau_(1 / smallest) {}

  /// A step of length alpha = r.z / p.Kp was made from a residual with r.z = `delta`.
  void advance(double alpha, double delta) {
    gained_ += alpha * delta;
    alpha_.push_back(alpha);
  }
  /// The new residual has `beta` times the old one's r.z.
  void turn(double beta) {
    radau_ = next_radau(radau_, alpha_.back(), beta, smallest_);
    beta_.push_back(beta);
  }

  /// e.Ke of the error that is left, N m, for r.z = `delta` now.
  [[nodiscard]] double left(double delta) const { return radau_ * delta; }
  /// By how much e.Ke has fallen, N m: exact (Hestenes & Stiefel 1952, theorem 6:1).
  [[nodiscard]] double gained() const { return gained_; }
  /// The smallest Ritz value of B K: an estimate of the smallest eigenvalue, from above.
  [[nodiscard]] double smallest_ritz() const { return extreme_ritz_values(alpha_, beta_).smallest; }

private:
  /// Starts again where `smallest` turns out to have been too large.
  [[nodiscard]] static double next_radau(double radau, double alpha, double beta, double smallest) {
    const double rest = radau - alpha;
    return rest > 1e-3 * alpha ? rest / (smallest * rest + beta) : 1 / smallest;
  }

  double smallest_ = 1;
  double radau_ = 1;
  double gained_ = 0;
  std::vector<double> alpha_, beta_;
};

/// What one solve tells the next ones about the smallest eigenvalue of B K.
[[nodiscard]] inline double sharper_bound(double smallest, const energy_bound& solved) {
  return std::min(smallest, 0.8 * solved.smallest_ritz());
}

}  // namespace tedit::fem
