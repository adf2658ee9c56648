// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/node_smoother.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>

#include "fem/multilevel/cluster_inverse.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

member_lists::member_lists(std::span<const std::uint32_t> owner, std::uint32_t owners) {
  std::vector<std::uint32_t> next(owners, 0);
  polled_for(owner.size(), [&](std::size_t i) {
    if (owner[i] != no_id)
      ++next[owner[i]];
  });
  places = row_places(next);
  polled_resize(item, places.room());
  for (std::uint32_t o = 0; o < owners; ++o)
    next[o] = places.begin(o);
  polled_for(owner.size(), [&](std::size_t i) {
    if (owner[i] != no_id)
      item[next[owner[i]]++] = static_cast<std::uint32_t>(i);
  });
}

void member_lists::replace(std::uint32_t owner, std::span<const std::uint32_t> items) {
  while (owner >= places.size())
    places.add(0);
  const auto at = places.replace(owner, static_cast<std::uint32_t>(items.size()));
  item.resize(places.room());
  std::ranges::copy(items, item.begin() + at);
}

template <class L>
void add_clusters(const cluster_inverses& clusters, float factor, const float* r, float* d) {
  for_lanes<L>(
    clusters.inverse.size(),
    [&](std::size_t first, std::size_t last) TEDIT_INLINED {
      std::vector<float> local;
      for (std::size_t c = first; c < last; ++c) {
        const auto nodes = clusters.nodes.of(c);
        const std::size_t size = 3 * nodes.size();
        local.resize(L::width * size);
        for (std::size_t a = 0; a < nodes.size(); ++a)
          std::copy_n(r + 3 * L::width * nodes[a], 3 * L::width, &local[3 * L::width * a]);
        const float* row = clusters.inverse[c].data();
        for (const auto node : nodes)
          for (std::size_t at = 3 * std::size_t{node}, end = at + 3; at < end; ++at, row += size) {
            typename L::scalar sum{};
            for (std::size_t j = 0; j < size; ++j)
              sum += row[j] * L::load_scalar(local.data(), j);
            L::store_scalar(L::load_scalar(d, at) + factor * sum, d, at);
          }
      }
    },
    16);
}

template <class L>
void apply_inverse(const node_smoother& smoother, float factor, const float* r, float* d) {
  for_lanes<L>(smoother.inverse.size(), [&](std::size_t first, std::size_t last) TEDIT_INLINED {
    for (std::size_t n = first; n < last; ++n)
      L::store(factor * multiply_symmetric(smoother.inverse[n], L::load(r, n)), d, n);
  });
  if (!smoother.clusters.empty())
    add_clusters<L>(smoother.clusters, factor, r, d);
}

template void add_clusters<one_case>(const cluster_inverses&, float, const float*, float*);
template void add_clusters<cases_of<4>>(const cluster_inverses&, float, const float*, float*);
template void add_clusters<cases_of<8>>(const cluster_inverses&, float, const float*, float*);
template void apply_inverse<one_case>(const node_smoother&, float, const float*, float*);
template void apply_inverse<cases_of<4>>(const node_smoother&, float, const float*, float*);
template void apply_inverse<cases_of<8>>(const node_smoother&, float, const float*, float*);

namespace {

Eigen::Matrix3d filled(const auto& s) {
  Eigen::Matrix3d m;
  m << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  return m;
}

}  // namespace

Eigen::MatrixXd cluster_matrix(const block_matrix& k, std::span<const std::uint32_t> nodes) {
  const auto size = static_cast<Eigen::Index>(3 * nodes.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto i = nodes[a];
    const auto at = static_cast<Eigen::Index>(3 * a);
    m.block<3, 3>(at, at) = filled(diagonal_block(k, i));
    for (auto e = k.begin(i); e < k.end(i); ++e) {
      const auto found = std::ranges::lower_bound(nodes, k.column[e]);
      if (found == nodes.end() || *found != k.column[e])
        continue;
      const auto values = k.block(e);
      m.block<3, 3>(at, 3 * (found - nodes.begin())) =
        Eigen::Map<const Eigen::Matrix3f>(values.data()).cast<double>();
    }
  }
  return m;
}

std::vector<float> invert_cluster(Eigen::MatrixXd m, filter_span filter,
                                  std::span<const std::uint32_t> nodes) {
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto at = static_cast<Eigen::Index>(3 * a);
    const Eigen::Matrix3d s = filled(filter[nodes[a]]);
    const double scale = m.block<3, 3>(at, at).trace() / 3;
    m.middleRows<3>(at) = (s * m.middleRows<3>(at)).eval();
    m.middleCols<3>(at) = (m.middleCols<3>(at) * s).eval();
    m.block<3, 3>(at, at) += scale * (Eigen::Matrix3d::Identity() - s);
  }
  Eigen::LDLT<Eigen::MatrixXd> factor(m);
  if (factor.info() != Eigen::Success || !factor.isPositive()) {
    m.diagonal() *= 1 + 1e-6;
    factor.compute(m);
  }
  Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(m.rows(), m.cols()));
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const Eigen::Matrix3d s = filled(filter[nodes[a]]);
    const auto at = static_cast<Eigen::Index>(3 * a);
    inverse.middleRows<3>(at) = (s * inverse.middleRows<3>(at)).eval();
    inverse.middleCols<3>(at) = (inverse.middleCols<3>(at) * s).eval();
  }
  const Eigen::MatrixXf result = (0.5 * (inverse + inverse.transpose())).cast<float>();
  return {result.data(), result.data() + result.size()};
}

void invert_clusters(const sliver_clusters& clusters, filter_span filter,
                     const cluster_matrix_of& matrix_of, node_smoother& smoother) {
  if (clusters.count == 0)
    return;
  auto& result = smoother.clusters;
  result.nodes = member_lists(clusters.of, clusters.count);
  result.inverse.resize(clusters.count);
  parallel_for(
    clusters.count,
    [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t c = first; c < last; ++c) {
        const auto nodes = result.nodes.of(c);
        result.inverse[c] = invert_cluster(matrix_of(nodes), filter, nodes);
      }
    },
    4);
  for (const auto node : result.nodes.item)
    smoother.inverse[node] = {};
}

node_smoother make_node_smoother(const block_matrix& k,
                                 std::span<const std::array<double, 6>> filter,
                                 const sliver_clusters& clusters) {
  node_smoother result;
  result.inverse = invert_blocks(diagonal_blocks(k), filter);
  invert_clusters(
    clusters, filter,
    [&](std::span<const std::uint32_t> nodes) { return cluster_matrix(k, nodes); }, result);
  return result;
}

std::vector<std::uint32_t> update_smoother(const smoother_source& source,
                                           std::span<const std::uint32_t> nodes,
                                           std::vector<std::uint32_t>& cluster_of,
                                           node_smoother& smoother) {
  const auto held = [&](std::uint32_t n) {
    const auto& s = source.filter[n];
    return s[0] + s[3] + s[5] < 1e-9;
  };
  auto& lists = smoother.clusters;
  sliver_clusters clusters{std::move(cluster_of), lists.nodes.owners()};
  auto change = recluster(
    source.p, nodes, [&](std::uint32_t n) { return n >= source.filter.size() || held(n); },
    source.elements_at, [&](std::uint32_t c) { return lists.nodes.of(c); }, source.most,
    source.condition, clusters);
  cluster_of = std::move(clusters.of);
  lists.inverse.resize(clusters.count);
  for (std::size_t i = 0; i < change.clusters.size(); ++i) {
    check_cancelled();
    const auto c = change.clusters[i];
    const std::span<const std::uint32_t> members = change.members[i];
    lists.nodes.replace(c, members);
    lists.inverse[c].clear();
    if (!members.empty())
      lists.inverse[c] = invert_cluster(source.matrix_of(members), source.filter, members);
  }
  smoother.inverse.resize(source.filter.size());
  polled_for(
    change.nodes.size(),
    [&](std::size_t i) {
      const auto n = change.nodes[i];
      smoother.inverse[n] = n < cluster_of.size() && cluster_of[n] != no_id
                              ? std::array<float, 6>{}
                              : invert_block(source.diagonal_of(n), source.filter[n]);
    },
    512);
  lists.changed = std::move(change.clusters);
  smoother.changed = change.nodes;
  return change.nodes;
}

}  // namespace tedit::fem
