// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/caps/cap_lift.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace tedit::ops {

namespace {

using sparse = Eigen::SparseMatrix<double>;
using columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Cotangent of the angle at a; kept positive, so that every weight is and the matrix stays
/// definite.
double cotangent(vec3 a, vec3 b, vec3 c) {
  constexpr double least = 1e-3;
  constexpr double most = 20;  // cot 3 degrees
  const double sine = norm(cross(b - a, c - a));
  return sine > 0 ? std::clamp(dot(b - a, c - a) / sine, least, most) : most;
}

/// The values inside that are harmonic for the cotangent weights of the surface `at`, given those
/// of the first `fixed` points.
void make_harmonic(const planar_filling& filling, const std::vector<vec3>& at, std::size_t fixed,
                   columns& values) {
  const auto inner = static_cast<Eigen::Index>(at.size() - fixed);
  if (inner == 0)
    return;
  std::vector<Eigen::Triplet<double>> entries;
  columns right = columns::Zero(inner, 3);
  const auto add = [&](std::uint32_t i, std::uint32_t j, double weight) {
    if (i < fixed)
      return;
    const auto row = static_cast<int>(i - fixed);
    entries.emplace_back(row, row, weight);
    if (j < fixed)
      right.row(row) += weight * values.row(j);
    else
      entries.emplace_back(row, static_cast<int>(j - fixed), -weight);
  };
  for (const auto& t : filling.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto i = t[(k + 1) % 3];
      const auto j = t[(k + 2) % 3];
      const double weight = 0.5 * cotangent(at[t[k]], at[i], at[j]);
      add(i, j, weight);
      add(j, i, weight);
    }
  sparse matrix(inner, inner);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<sparse> factor(matrix);
  if (factor.info() == Eigen::Success)
    values.bottomRows(inner) = factor.solve(right);
}

}  // namespace

std::vector<vec3> lift_onto_rim(const planar_filling& filling, std::span<const vec3> rim) {
  constexpr int repeats = 5;
  std::vector<vec3> at;
  for (const auto& p : filling.points)
    at.push_back({p[0], p[1], 0});
  columns values = columns::Zero(static_cast<Eigen::Index>(at.size()), 3);
  for (std::size_t i = 0; i < rim.size(); ++i)
    values.row(static_cast<Eigen::Index>(i)) << rim[i].x, rim[i].y, rim[i].z;
  for (int round = 0; round <= repeats; ++round) {
    make_harmonic(filling, at, rim.size(), values);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto row = values.row(static_cast<Eigen::Index>(i));
      at[i] = {row[0], row[1], row[2]};
    }
  }
  std::ranges::copy(rim, at.begin());
  return at;
}

bool lift_onto_quadric(const planar_filling& filling, const quadric& shape, vec3 direction,
                       double reach, std::size_t rim_size, std::vector<vec3>& points) {
  columns rest = columns::Zero(static_cast<Eigen::Index>(points.size()), 3);
  std::vector<double> way(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto found = shape.along(points[i], direction);
    if (!found || std::abs(*found) > reach)
      return false;
    way[i] = *found;
    if (i < rim_size)
      rest(static_cast<Eigen::Index>(i), 0) = -*found;
  }
  make_harmonic(filling, points, rim_size, rest);
  for (std::size_t i = rim_size; i < points.size(); ++i)
    points[i] += (way[i] + rest(static_cast<Eigen::Index>(i), 0)) * direction;
  return true;
}

}  // namespace tedit::ops
