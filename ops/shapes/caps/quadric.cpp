// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/caps/quadric.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace tedit::ops {

namespace {

using monomials = Eigen::Matrix<double, 10, 1>;

monomials values_at(vec3 x) {
  monomials m;
  m << x.x * x.x, x.y * x.y, x.z * x.z, x.x * x.y, x.y * x.z, x.z * x.x, x.x, x.y, x.z, 1;
  return m;
}

/// Columns: d/dx, d/dy, d/dz of the monomials.
Eigen::Matrix<double, 10, 3> gradients_at(vec3 x) {
  Eigen::Matrix<double, 10, 3> g = Eigen::Matrix<double, 10, 3>::Zero();
  g(0, 0) = 2 * x.x;
  g(1, 1) = 2 * x.y;
  g(2, 2) = 2 * x.z;
  g(3, 0) = x.y;
  g(3, 1) = x.x;
  g(4, 1) = x.z;
  g(4, 2) = x.y;
  g(5, 2) = x.x;
  g(5, 0) = x.z;
  g(6, 0) = g(7, 1) = g(8, 2) = 1;
  return g;
}

}  // namespace

std::optional<quadric> fit_quadric(std::span<const vec3> points) {
  if (points.size() < 10)
    return std::nullopt;
  quadric q;
  for (const auto& p : points)
    q.origin += p / static_cast<double>(points.size());
  q.scale = 0;
  for (const auto& p : points)
    q.scale = std::max(q.scale, norm(p - q.origin));
  if (!(q.scale > 0))
    return std::nullopt;
  Eigen::Matrix<double, 10, 10> moments = Eigen::Matrix<double, 10, 10>::Zero();
  Eigen::Matrix<double, 10, 10> slopes = Eigen::Matrix<double, 10, 10>::Zero();
  for (const auto& p : points) {
    const vec3 x = (p - q.origin) / q.scale;
    const auto m = values_at(x);
    const auto g = gradients_at(x);
    moments += m * m.transpose();
    slopes += g * g.transpose();
  }
  // The constant has no slope: take it out first, so that the norm is positive definite.
  const Eigen::Matrix<double, 9, 1> mixed = moments.topRightCorner<9, 1>();
  const Eigen::Matrix<double, 9, 9> reduced =
    moments.topLeftCorner<9, 9>() - mixed * mixed.transpose() / moments(9, 9);
  const Eigen::Matrix<double, 9, 9> metric =
    slopes.topLeftCorner<9, 9>() + 1e-12 * slopes.trace() * Eigen::Matrix<double, 9, 9>::Identity();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> solver(reduced,
                                                                                     metric);
  if (solver.info() != Eigen::Success)
    return std::nullopt;
  const Eigen::Matrix<double, 9, 1> best = solver.eigenvectors().col(0);
  for (int i = 0; i < 9; ++i)
    q.c[i] = best[i];
  q.c[9] = -mixed.dot(best) / moments(9, 9);
  return q;
}

std::optional<double> quadric::along(vec3 p, vec3 d) const {
  const vec3 x = (p - origin) / scale;
  const Eigen::Map<const monomials> coefficients(c.data());
  const vec3 one = x + d;
  const vec3 other = x - d;
  // f(x + t d) = a t^2 + b t + f0, from three values.
  const double f0 = coefficients.dot(values_at(x));
  const double f1 = coefficients.dot(values_at(one));
  const double f2 = coefficients.dot(values_at(other));
  const double a = 0.5 * (f1 + f2) - f0;
  const double b = 0.5 * (f1 - f2);
  const double inside = b * b - 4 * a * f0;
  if (inside < 0)
    return std::nullopt;
  // The root of smaller size without cancellation.
  const double divisor = b + std::copysign(std::sqrt(inside), b);
  if (divisor == 0)
    return f0 == 0 ? std::optional<double>(0) : std::nullopt;
  return -2 * f0 / divisor * scale;
}

void quadric::flip() {
  for (auto& coefficient : c)
    coefficient = -coefficient;
}

double quadric::signed_distance(vec3 p) const {
  const vec3 x = (p - origin) / scale;
  const Eigen::Map<const monomials> coefficients(c.data());
  const double slope = (gradients_at(x).transpose() * coefficients).norm();
  return scale * coefficients.dot(values_at(x)) / std::max(slope, 1e-300);
}

}  // namespace tedit::ops
