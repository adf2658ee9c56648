// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/quadratic_level.hpp"

#include <Eigen/Dense>

#include <algorithm>

#include "base/raw_vector.hpp"
#include "fem/element.hpp"
#include "fem/element_operator.hpp"
#include "fem/multilevel/cluster_inverse.hpp"
#include "fem/multilevel/lanczos.hpp"
#include "fem/multilevel/node_smoother.hpp"
#include "fem/polled.hpp"

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

/// The integral of grad N_a (x) grad N_a over an element, upper triangle: with grad N_a linear
/// between the corners, 12 V/20 g_a (x) g_a at a corner; in the middle of the edge ij, h = g_i +
/// g_j, 16 V/20 (g_i (x) g_i + g_j (x) g_j + h (x) h).
std::array<double, 6> gradient_square(const tet_gradients& g, int a) {
  const auto add = [](double weight, vec3 v, std::array<double, 6>& to) {
    const vec3 w = weight * v;
    to[0] += w.x * v.x;
    to[1] += w.x * v.y;
    to[2] += w.x * v.z;
    to[3] += w.y * v.y;
    to[4] += w.y * v.z;
    to[5] += w.z * v.z;
  };
  std::array<double, 6> m{};
  if (a < 4) {
    add(0.6 * g.volume, g.gradient[a], m);
    return m;
  }
  const auto [i, j] = edge_corners[a - 4];
  for (const auto v : {g.gradient[i], g.gradient[j], g.gradient[i] + g.gradient[j]})
    add(0.8 * g.volume, v, m);
  return m;
}

/// K_aa of the node where element corners meet, upper triangle: the sum of (lambda + mu) M +
/// mu tr(M) I with M from `gradient_square`. `corners`: element * 10 + local node.
template <class Corners>
std::array<float, 6> diagonal_block(const problem& p, const Corners& corners) {
  std::array<double, 6> sum{};
  double pure = 0;
  for (const auto corner : corners) {
    const auto m = gradient_square(gradients_of(p, corner / 10), static_cast<int>(corner % 10));
    const auto& c = p.constants[p.element_materials[corner / 10]];
    for (std::size_t i = 0; i < 6; ++i)
      sum[i] += (c.lambda + c.mu) * m[i];
    pure += c.mu * (m[0] + m[3] + m[5]);
  }
  for (const std::size_t i : {0, 3, 5})
    sum[i] += pure;
  std::array<float, 6> result;
  std::ranges::transform(sum, result.begin(), [](double s) { return static_cast<float>(s); });
  return result;
}

/// The matrix of a cluster's nodes, from every element that touches two of them or one.
template <class CornersAt>
Eigen::MatrixXd cluster_matrix(const problem& p, const CornersAt& corners_at,
                               std::span<const std::uint32_t> nodes) {
  const auto size = static_cast<Eigen::Index>(3 * nodes.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (const auto corner : corners_at(nodes[a])) {
      const std::size_t e = corner / 10;
      const auto g = gradients_of(p, e);
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

std::vector<std::uint32_t> element_corners_at(const problem& p, const incidence& corners,
                                              std::uint32_t node) {
  const bool corner_node = node < p.corner_count;
  const auto around = corners.of_node(corner_node ? node : p.edge_ends[node - p.corner_count][0]);
  if (corner_node)
    return {around.begin(), around.end()};
  std::vector<std::uint32_t> result;
  for (const auto corner : around) {
    const std::uint32_t e = corner / 10;
    const auto* n = &p.element_nodes[10 * std::size_t{e}];
    const auto* found = std::find(n + 4, n + 10, node);
    if (found != n + 10)
      result.push_back(10 * e + static_cast<std::uint32_t>(found - n));
  }
  return result;
}

edge_transfer make_edge_transfer(const problem& quadratic) {
  edge_transfer result;
  reserve_for_edits(result.ends, quadratic.edge_ends.size());
  result.ends = quadratic.edge_ends;
  if (!result.ends.empty())
    result.middles = member_lists({result.ends.front().data(), 2 * result.ends.size()},
                                  static_cast<std::uint32_t>(quadratic.corner_count));
  return result;
}

node_smoother make_quadratic_smoother(const problem& quadratic, filter_span filter,
                                      const sliver_clusters& clusters) {
  const incidence around(quadratic);
  raw_vector<std::array<float, 6>> diagonal(quadratic.node_count());
  parallel_for(diagonal.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      diagonal[n] = diagonal_block(quadratic, around.of_node(n));
  });
  node_smoother result;
  result.inverse = invert_blocks(diagonal, filter);
  const auto corners_at = [&](std::uint32_t n) { return around.of_node(n); };
  invert_clusters(
    clusters, filter,
    [&](std::span<const std::uint32_t> nodes) {
      return cluster_matrix(quadratic, corners_at, nodes);
    },
    result);
  return result;
}

void update_edge_transfer(const problem& quadratic, edge_transfer& edges) {
  for (auto i = static_cast<std::uint32_t>(edges.ends.size()); i < quadratic.edge_ends.size();
       ++i) {
    edges.ends.push_back(quadratic.edge_ends[i]);
    for (std::uint32_t side = 0; side < 2; ++side) {
      const auto end = edges.ends[i][side];
      const auto old = edges.middles.of(end);
      std::vector<std::uint32_t> more(old.begin(), old.end());
      more.push_back(2 * i + side);
      edges.middles.replace(end, more);
    }
  }
}

namespace {

/// The elements at some nodes as a problem of their own, without supports and loads; `numbers`
/// becomes the whole's number of each of its nodes.
problem part_at(const problem& p, const incidence& corners, std::span<const std::uint32_t> nodes,
                std::vector<std::uint32_t>& numbers) {
  std::vector<std::uint32_t> elements;
  for (const auto n : nodes)
    for (const auto corner : element_corners_at(p, corners, n))
      elements.push_back(corner / 10);
  sort_unique(elements);
  const auto nodes_of = [&](std::uint32_t e) {
    return std::span(p.element_nodes).subspan(10 * std::size_t{e}, 10);
  };
  numbers.clear();
  for (const auto e : elements)
    numbers.insert(numbers.end(), nodes_of(e).begin(), nodes_of(e).end());
  sort_unique(numbers);
  problem part;
  part.element_order = 2;
  part.nodes_per_element = 10;
  const auto place = [&](std::uint32_t n) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(numbers, n) - numbers.begin());
  };
  part.corner_count = place(static_cast<std::uint32_t>(p.corner_count));
  for (const auto n : numbers)
    part.nodes.push_back(p.nodes[n]);
  part.constants = p.constants;
  for (const auto e : elements) {
    part.element_tets.push_back(p.element_tets[e]);
    part.element_materials.push_back(p.element_materials[e]);
    for (const auto n : nodes_of(e))
      part.element_nodes.push_back(place(n));
  }
  return part;
}

/// A lower bound of the whole's largest eigenvalue: rows at the rim of the part lack elements.
float local_eigenvalue(const problem& part, std::span<const std::uint32_t> numbers, int steps,
                       std::span<const std::array<float, 6>> inverse) {
  if (part.element_count() == 0)
    return 0;
  const element_operator k(part);
  std::vector<double> wide(part.dofs());
  std::vector<double> product(part.dofs());
  return largest_ritz_value(
    part.dofs(), 1, steps,
    [&](const float* x, float* y) {
      std::copy_n(x, wide.size(), wide.begin());
      k.apply(wide, product);
      std::ranges::transform(product, y, [](double v) { return static_cast<float>(v); });
    },
    [&](const float* x, float* y) {
      for (std::size_t i = 0; i < numbers.size(); ++i)
        store3(multiply_symmetric(inverse[numbers[i]], load4(x + 3 * i)), y + 3 * i);
    });
}

}  // namespace

void update_quadratic_smoother(const problem& quadratic, const incidence& corners,
                               filter_span filter, std::span<const std::uint32_t> nodes,
                               const multilevel_settings& settings,
                               std::vector<std::uint32_t>& cluster_of, node_smoother& smoother) {
  const auto corners_at = [&](std::uint32_t n) {
    return element_corners_at(quadratic, corners, n);
  };
  const smoother_source source{
    quadratic,
    filter,
    [&](std::uint32_t n) {
      auto elements = corners_at(n);
      for (auto& e : elements)
        e /= 10;
      return elements;
    },
    [&](std::uint32_t n) { return diagonal_block(quadratic, corners_at(n)); },
    [&](std::span<const std::uint32_t> members) {
      return cluster_matrix(quadratic, corners_at, members);
    },
    100,
    settings.sliver_condition};
  const auto touched = update_smoother(source, nodes, cluster_of, smoother);
  std::vector<std::uint32_t> numbers;
  const auto part = part_at(quadratic, corners, touched, numbers);
  smoother.lambda = std::max(
    smoother.lambda, settings.lambda_safety *
                       local_eigenvalue(part, numbers, settings.lambda_steps, smoother.inverse));
}

}  // namespace tedit::fem
