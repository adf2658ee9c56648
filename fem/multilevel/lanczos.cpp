// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/lanczos.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/parallel.hpp"
#include "base/raw_vector.hpp"
#include "fem/wide.hpp"

namespace tedit::fem {

namespace {

float noise(std::uint64_t i) {
  i = (i + 1) * 0x9E3779B97F4A7C15;
  i ^= i >> 29;
  i *= 0xBF58476D1CE4E5B9;
  return static_cast<float>(i >> 40) / static_cast<float>(1 << 24) - 0.5F;
}

/// Calls `work(i)` for every i of [0, items), on all cores.
template <class Work>
void for_entries(std::size_t items, const Work& work) {
  parallel_for(items, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      work(i);
  });
}

double inner(const raw_vector<float>& a, const raw_vector<float>& b, std::size_t n) {
  return parallel_sum(n, [&](std::size_t first, std::size_t last) {
    double result = 0;
    run_widest([&]() TEDIT_INLINED {
      double4 sums{};
      auto i = first;
      for (; i + 4 <= last; i += 4)
        sums += __builtin_convertvector(load4(&a[i]), double4) *
                __builtin_convertvector(load4(&b[i]), double4);
      for (; i < last; ++i)
        result += static_cast<double>(a[i]) * static_cast<double>(b[i]);
      result += (sums[0] + sums[1]) + (sums[2] + sums[3]);
    });
    return result;
  });
}

}  // namespace

ritz_range extreme_ritz_values(std::span<const double> alpha, std::span<const double> beta) {
  constexpr std::size_t most = 100;  // More steps add nothing, and the cost grows with the square.
  const std::size_t steps = std::min({alpha.size(), beta.size() + 1, most});
  if (steps == 0)
    return {};
  Eigen::VectorXd diagonal(static_cast<Eigen::Index>(steps));
  Eigen::VectorXd beside(static_cast<Eigen::Index>(steps - 1));
  for (std::size_t i = 0; i < steps; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    diagonal[at] = 1 / alpha[i] + (i > 0 ? beta[i - 1] / alpha[i - 1] : 0);
    if (i + 1 < steps)
      beside[at] = std::sqrt(beta[i]) / alpha[i];
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz;
  ritz.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return {ritz.eigenvalues()[0], ritz.eigenvalues()[diagonal.size() - 1]};
}

float largest_ritz_value(std::size_t unknowns, std::size_t padding, int steps, const vector_map& a,
                         const vector_map& b) {
  const std::size_t n = unknowns + padding;
  raw_vector<float> r(n);
  raw_vector<float> z(n);
  raw_vector<float> q(n);
  raw_vector<float> p(n);
  for (auto* v : {&r, &z, &q, &p})
    std::fill(v->begin() + static_cast<std::ptrdiff_t>(unknowns), v->end(), 0.0F);
  for_entries(unknowns, [&](std::size_t i) { r[i] = noise(i); });
  b(r.data(), z.data());
  for_entries(unknowns, [&](std::size_t i) { p[i] = z[i]; });
  double rz = inner(r, z, unknowns);
  std::vector<double> alphas;
  std::vector<double> betas;
  for (int step = 0; step < steps && rz > 0; ++step) {
    a(p.data(), q.data());
    const double bend = inner(p, q, unknowns);
    if (!(bend > 0))
      break;
    const double alpha = rz / bend;
    alphas.push_back(alpha);
    const auto down = static_cast<float>(alpha);
    for_entries(unknowns, [&](std::size_t i) { r[i] -= down * q[i]; });
    b(r.data(), z.data());
    const double next = inner(r, z, unknowns);
    if (!(next > 1e-12 * rz))
      break;
    betas.push_back(next / rz);
    rz = next;
    const auto keep = static_cast<float>(betas.back());
    for_entries(unknowns, [&](std::size_t i) { p[i] = z[i] + keep * p[i]; });
  }
  return static_cast<float>(extreme_ritz_values(alphas, betas).largest);
}

}  // namespace tedit::fem
