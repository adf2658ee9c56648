// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/quadratic_level.hpp"

#include <Eigen/Dense>

#include <algorithm>

#include "fem/element.hpp"
#include "fem/multilevel/cluster_inverse.hpp"
#include "fem/multilevel/node_smoother.hpp"

namespace tedit::fem {

namespace {

/// Corners of the edges in the order of their middle nodes 4..9.
constexpr std::array<std::array<int, 2>, 6> edge_corners{
  {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// The gradient of shape function `a` at the four corners; linear in between.
std::array<vec3, 4> corner_gradients(const tet_gradients& g, int a) {
  std::array<vec3, 4> v;
  if (a < 4) {
    for (int k = 0; k < 4; ++k)
      v[k] = (k == a ? 3.0 : -1.0) * g.gradient[a];
    return v;
  }
  const auto [i, j] = edge_corners[a - 4];
  v[i] = 4.0 * g.gradient[j];
  v[j] = 4.0 * g.gradient[i];
  return v;
}

/// The block K_ab of an element: the integral of two linear fields is V/20 (sum_k v_k w_k + sum v
/// sum w).
Eigen::Matrix3d element_block(const std::array<vec3, 4>& v, const std::array<vec3, 4>& w,
                              double volume, const lame_constants& c) {
  const auto eigen = [](vec3 x) { return Eigen::Vector3d(x.x, x.y, x.z); };
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  vec3 all_v;
  vec3 all_w;
  for (int k = 0; k < 4; ++k) {
    m += eigen(v[k]) * eigen(w[k]).transpose();
    all_v += v[k];
    all_w += w[k];
  }
  m += eigen(all_v) * eigen(all_w).transpose();
  m *= volume / 20;
  return c.lambda * m + c.mu * m.transpose() + c.mu * m.trace() * Eigen::Matrix3d::Identity();
}

tet_gradients gradients_at(const problem& p, std::size_t e) {
  const auto* n = &p.element_nodes[10 * e];
  return gradients_of({p.nodes[n[0]], p.nodes[n[1]], p.nodes[n[2]], p.nodes[n[3]]});
}

std::vector<std::array<float, 6>> diagonal_blocks(const problem& p, const incidence& around) {
  std::vector<std::array<float, 6>> result(p.node_count());
  parallel_for(p.node_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (const auto corner : around.of_node(n)) {
        const auto g = gradients_at(p, corner / 10);
        const auto v = corner_gradients(g, static_cast<int>(corner % 10));
        sum += element_block(v, v, g.volume, p.constants[p.element_materials[corner / 10]]);
      }
      int c = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
          result[n][c++] = static_cast<float>(sum(i, j));
    }
  });
  return result;
}

/// The matrix of a cluster's nodes, from every element that touches two of them or one.
Eigen::MatrixXd cluster_matrix(const problem& p, const incidence& around,
                               std::span<const std::uint32_t> nodes) {
  const auto size = static_cast<Eigen::Index>(3 * nodes.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (const auto corner : around.of_node(nodes[a])) {
      const std::size_t e = corner / 10;
      const auto g = gradients_at(p, e);
      const auto v = corner_gradients(g, static_cast<int>(corner % 10));
      for (int b = 0; b < 10; ++b) {
        const auto found = std::ranges::lower_bound(nodes, p.element_nodes[10 * e + b]);
        if (found == nodes.end() || *found != p.element_nodes[10 * e + b])
          continue;
        m.block<3, 3>(static_cast<Eigen::Index>(3 * a), 3 * (found - nodes.begin())) +=
          element_block(v, corner_gradients(g, b), g.volume, p.constants[p.element_materials[e]]);
      }
    }
  return m;
}

}  // namespace

problem corner_problem(const problem& quadratic) {
  problem p;
  const std::size_t corners = quadratic.corner_count;
  p.nodes.assign(quadratic.nodes.begin(), quadratic.nodes.begin() + static_cast<long>(corners));
  p.node_vertices = quadratic.node_vertices;
  p.corner_count = corners;
  p.element_nodes.reserve(4 * quadratic.element_count());
  for (std::size_t e = 0; e < quadratic.element_count(); ++e)
    for (int a = 0; a < 4; ++a)
      p.element_nodes.push_back(quadratic.element_nodes[10 * e + a]);
  p.element_tets = quadratic.element_tets;
  p.element_materials = quadratic.element_materials;
  p.constants = quadratic.constants;
  p.filter.assign(quadratic.filter.begin(), quadratic.filter.begin() + static_cast<long>(corners));
  return p;
}

edge_transfer make_edge_transfer(const problem& quadratic, filter_span filter) {
  edge_transfer result;
  result.ends = quadratic.edge_ends;
  std::vector<std::uint32_t> owner;
  owner.reserve(2 * result.ends.size());
  for (const auto& ends : result.ends)
    owner.insert(owner.end(), ends.begin(), ends.end());
  result.middles = member_lists(owner, static_cast<std::uint32_t>(quadratic.corner_count));
  bool filtered = false;
  result.held.resize(filter.size());
  for (std::size_t n = 0; n < filter.size(); ++n) {
    const double trace = filter[n][0] + filter[n][3] + filter[n][5];
    result.held[n] = trace < 1e-9 ? 1 : 0;
    filtered = filtered || trace < 3 - 1e-9;
  }
  if (!filtered)
    return result;
  result.filter.resize(filter.size());
  for (std::size_t n = 0; n < filter.size(); ++n)
    std::ranges::transform(filter[n], result.filter[n].begin(),
                           [](double s) { return static_cast<float>(s); });
  return result;
}

node_smoother make_quadratic_smoother(const problem& quadratic, filter_span filter,
                                      const sliver_clusters& clusters) {
  const incidence around(quadratic);
  node_smoother result;
  result.inverse = invert_blocks(diagonal_blocks(quadratic, around), filter);
  invert_clusters(
    clusters, filter,
    [&](std::span<const std::uint32_t> nodes) { return cluster_matrix(quadratic, around, nodes); },
    result);
  return result;
}

}  // namespace tedit::fem
