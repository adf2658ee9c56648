// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/energy_bound.hpp"

#include <gtest/gtest.h>

namespace tedit::fem {

namespace {

/// Conjugate gradients on a diagonal matrix, where the error is known at every step.
struct diagonal_solve {
  std::vector<double> k, x, r, p;
  energy_bound bound;

  diagonal_solve(std::vector<double> diagonal, std::vector<double> solution, double smallest)
      : k(std::move(diagonal)), x(std::move(solution)), bound(smallest) {
    for (std::size_t i = 0; i < k.size(); ++i)
      r.push_back(k[i] * x[i]);
    p = r;
  }

  [[nodiscard]] double delta() const {
    double sum = 0;
    for (const double v : r)
      sum += v * v;
    return sum;
  }

  /// e.Ke; x becomes the error by and by.
  [[nodiscard]] double error() const {
    double sum = 0;
    for (std::size_t i = 0; i < k.size(); ++i)
      sum += k[i] * x[i] * x[i];
    return sum;
  }

  void step() {
    double bend = 0;
    for (std::size_t i = 0; i < k.size(); ++i)
      bend += p[i] * k[i] * p[i];
    const double before = delta();
    const double alpha = before / bend;
    for (std::size_t i = 0; i < k.size(); ++i) {
      x[i] -= alpha * p[i];
      r[i] -= alpha * k[i] * p[i];
    }
    const double beta = delta() / before;
    for (std::size_t i = 0; i < k.size(); ++i)
      p[i] = r[i] + beta * p[i];
    bound.advance(alpha, before);
    bound.turn(beta);
  }
};

/// Mostly easy, with one eigenvalue that is far smaller: what an edit leaves.
std::vector<double> spectrum() {
  std::vector<double> k{0.05};
  for (int i = 0; i < 40; ++i)
    k.push_back(0.3 + 0.02 * i);
  return k;
}

}  // namespace

TEST(EnergyBound, IsAboveTheErrorAndNearItAtEveryStep) {
  const auto k = spectrum();
  std::vector<double> solution(k.size(), 0.01);
  solution[0] = 1;  // r.r sees little of it.
  diagonal_solve cg(k, solution, 0.04);
  const double start = cg.error();
  EXPECT_LT(cg.delta(), 0.2 * start);

  for (int i = 0; i < 12; ++i) {
    EXPECT_GE(cg.bound.left(cg.delta()), cg.error()) << "step " << i;
    EXPECT_LE(cg.bound.left(cg.delta()), 16 * cg.error()) << "step " << i;  // 4 in the norm
    EXPECT_NEAR(cg.bound.gained(), start - cg.error(), 1e-12);
    cg.step();
  }
}

TEST(EnergyBound, OneStepOnTheIdentityLeavesNothing) {
  diagonal_solve cg({2, 2, 2}, {1, 2, 3}, 2);
  EXPECT_DOUBLE_EQ(cg.bound.left(cg.delta()), 28);  // 2 (1 + 4 + 9)

  cg.step();

  EXPECT_DOUBLE_EQ(cg.bound.gained(), 28);
  EXPECT_NEAR(cg.bound.left(cg.delta()), 0, 1e-12);
}

TEST(EnergyBound, ASmallestEigenvalueThatWasTooLargeIsNoticedAndLearned) {
  const auto k = spectrum();
  diagonal_solve cg(k, std::vector<double>(k.size(), 1.0), 0.2);
  for (int i = 0; i < 12; ++i)
    cg.step();

  EXPECT_NEAR(cg.bound.smallest_ritz(), 0.05, 1e-6);
  EXPECT_NEAR(sharper_bound(0.2, cg.bound), 0.04, 1e-6);
  EXPECT_GT(cg.bound.left(cg.delta()), 0);
}

TEST(EnergyBound, NothingIsKnownWithoutASolve) {
  EXPECT_EQ(sharper_bound(0.1, energy_bound(0.1)), 0.1);
}

}  // namespace tedit::fem
