// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Sparse>

#include "fem/element.hpp"
#include "tests/support/meshes.hpp"

/// Textbook element matrices by Gauss quadrature and a direct solver: what the fast code is
/// measured against.
namespace tedit::fem::test {

using namespace tedit::test;
using vector = Eigen::VectorXd;

/// Gradients of the shape functions at barycentric coordinates `l`.
inline std::vector<vec3> shape_gradients(const tet_gradients& g, int order,
                                         const std::array<double, 4>& l) {
  if (order == 1)
    return {g.gradient.begin(), g.gradient.end()};
  std::vector<vec3> result;
  for (int k = 0; k < 4; ++k)
    result.push_back((4 * l[k] - 1) * g.gradient[k]);
  constexpr std::array<std::array<int, 2>, 6> edges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  for (const auto& [i, j] : edges)
    result.push_back(4 * (l[i] * g.gradient[j] + l[j] * g.gradient[i]));
  return result;
}

/// Element stiffness, N/m, by four Gauss points (exact for polynomials of degree 2).
inline Eigen::MatrixXd element_matrix(const problem& p, std::size_t e) {
  const auto g = gradients_of(p, e);
  const auto& c = p.constants[p.element_materials[e]];
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
  d.topLeftCorner<3, 3>().setConstant(c.lambda);
  d.diagonal() << c.lambda + 2 * c.mu, c.lambda + 2 * c.mu, c.lambda + 2 * c.mu, c.mu, c.mu, c.mu;
  const int n = p.nodes_per_element;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  const double near = (5 + 3 * std::sqrt(5.0)) / 20;
  for (int point = 0; point < 4; ++point) {
    std::array<double, 4> l;
    l.fill((1 - near) / 3);
    l[point] = near;
    const auto gradients = shape_gradients(g, p.element_order, l);
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(6, 3 * n);
    for (int a = 0; a < n; ++a) {
      const vec3 s = gradients[a];
      b.block<6, 3>(0, 3 * a) << s.x, 0, 0, 0, s.y, 0, 0, 0, s.z, s.y, s.x, 0, 0, s.z, s.y, s.z, 0,
        s.x;
    }
    k += (g.volume / 4) * b.transpose() * d * b;
  }
  return k;
}

/// The stiffness matrix of all elements.
inline Eigen::SparseMatrix<double> stiffness(const problem& p) {
  std::vector<Eigen::Triplet<double>> entries;
  const std::size_t n = p.nodes_per_element;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const auto k = element_matrix(p, e);
    const auto dof = [&](Eigen::Index i) {
      return static_cast<int>(3 * p.element_nodes[n * e + i / 3] + i % 3);
    };
    for (Eigen::Index i = 0; i < k.rows(); ++i)
      for (Eigen::Index j = 0; j < k.cols(); ++j)
        entries.emplace_back(dof(i), dof(j), k(i, j));
  }
  Eigen::SparseMatrix<double> result(p.dofs(), p.dofs());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The displacement: z + d with (S K S + c (I - S)) d = S (f - K z), by a direct solver.
inline std::vector<double> solve_directly(const problem& p) {
  const auto k = stiffness(p);
  std::vector<Eigen::Triplet<double>> entries;
  constexpr std::array<std::array<int, 3>, 3> place{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
  for (std::size_t n = 0; n < p.node_count(); ++n)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (const double s = p.filter[n][place[i][j]]; s != 0)
          entries.emplace_back(static_cast<int>(3 * n + i), static_cast<int>(3 * n + j), s);
  Eigen::SparseMatrix<double> s(p.dofs(), p.dofs());
  s.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseMatrix<double> one(p.dofs(), p.dofs());
  one.setIdentity();
  const double scale = k.diagonal().mean();
  const Eigen::SparseMatrix<double> free = s * k * s + scale * (one - s);
  const vector z = Eigen::Map<const vector>(p.prescribed.data(), p.dofs());
  const vector f = Eigen::Map<const vector>(p.loads.data(), p.dofs());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(free);
  const vector u = z + solver.solve(s * (f - k * z));
  return {u.data(), u.data() + u.size()};
}

/// The values of a field u(x) at the nodes.
inline std::vector<double> at_nodes(const problem& p, const std::function<vec3(vec3)>& field) {
  std::vector<double> result;
  for (const auto& x : p.nodes) {
    const vec3 u = field(x);
    result.insert(result.end(), {u.x, u.y, u.z});
  }
  return result;
}

/// MacNeal & Harder's field: u = 1e-3 (x + (y+z)/2, y + (x+z)/2, z + (x+y)/2).
inline vec3 patch_field(vec3 p) {
  return 1e-3 * vec3{p.x + 0.5 * (p.y + p.z), p.y + 0.5 * (p.x + p.z), p.z + 0.5 * (p.x + p.y)};
}

/// A point of a box, moved inside so that no two tets are alike.
inline vec3 shaken_inside(vec3 p, vec3 size) {
  const double s = 0.06 * std::sin(3.141592653589793 * p.x / size.x) *
                   std::sin(3.141592653589793 * p.y / size.y) *
                   std::sin(3.141592653589793 * p.z / size.z);
  return p + s * vec3{std::sin(7 * p.y), std::cos(5 * p.z), std::sin(3 * p.x + 1)};
}

/// A load case that any box takes: clamped on surface 1, pulled on surface 2.
inline load_case simple_case(double e, double nu) {
  load_case loads;
  loads.materials = {{"test", e, nu, 1000, 0, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{{1, 0, 0}}}};
  return loads;
}

}  // namespace tedit::fem::test
