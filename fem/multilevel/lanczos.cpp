// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/lanczos.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstdint>

#include "base/parallel.hpp"

namespace tedit::fem {

namespace {

float noise(std::uint64_t i) {
  i = (i + 1) * 0x9E3779B97F4A7C15;
  i ^= i >> 29;
  i *= 0xBF58476D1CE4E5B9;
  return static_cast<float>(i >> 40) / static_cast<float>(1 << 24) - 0.5F;
}

double inner(const std::vector<float>& a, const std::vector<float>& b, std::size_t n) {
  return parallel_sum(n, [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i)
      sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
  });
}

}  // namespace

float largest_ritz_value(std::size_t unknowns, std::size_t padding, int steps, const vector_map& a,
                         const vector_map& b) {
  const std::size_t n = unknowns + padding;
  std::vector<float> r(n, 0);
  std::vector<float> z(n, 0);
  std::vector<float> q(n, 0);
  for (std::size_t i = 0; i < unknowns; ++i)
    r[i] = noise(i);
  b(r.data(), z.data());
  std::vector<float> p = z;
  double rz = inner(r, z, unknowns);
  std::vector<double> diagonal;
  std::vector<double> beside;
  double last_alpha = 0;
  double last_beta = 0;
  for (int step = 0; step < steps && rz > 0; ++step) {
    a(p.data(), q.data());
    const double bend = inner(p, q, unknowns);
    if (!(bend > 0))
      break;
    const double alpha = rz / bend;
    diagonal.push_back(1 / alpha + (step > 0 ? last_beta / last_alpha : 0));
    if (step > 0)
      beside.push_back(std::sqrt(last_beta) / last_alpha);
    const auto down = static_cast<float>(alpha);
    for (std::size_t i = 0; i < unknowns; ++i)
      r[i] -= down * q[i];
    b(r.data(), z.data());
    const double next = inner(r, z, unknowns);
    if (!(next > 1e-12 * rz))
      break;
    last_beta = next / rz;
    last_alpha = alpha;
    rz = next;
    const auto keep = static_cast<float>(last_beta);
    for (std::size_t i = 0; i < unknowns; ++i)
      p[i] = z[i] + keep * p[i];
  }
  if (diagonal.empty())
    return 1;
  const auto count = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz;
  ritz.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), count),
                              Eigen::Map<const Eigen::VectorXd>(beside.data(), count - 1),
                              Eigen::EigenvaluesOnly);
  return static_cast<float>(ritz.eigenvalues()[count - 1]);
}

}  // namespace tedit::fem
