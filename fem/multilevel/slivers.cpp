// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/slivers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "fem/multilevel/galerkin.hpp"
#include "fem/polled.hpp"
#include "fem/rows.hpp"

namespace tedit::fem {

double tet_condition(const std::array<vec3, 4>& p) {
  const vec3 u = p[1] - p[0];
  const vec3 v = p[2] - p[0];
  const vec3 w = p[3] - p[0];
  const std::array<vec3, 3> faces{cross(v, w), cross(w, u), cross(u, v)};
  const double six_volumes = dot(u, faces[0]);
  if (!(six_volumes > 0))
    return std::numeric_limits<double>::infinity();
  const vec3 last = faces[0] + faces[1] + faces[2];
  double areas = dot(last, last);
  for (const auto& f : faces)
    areas += dot(f, f);
  double edges = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < a; ++b)
      edges += dot(p[a] - p[b], p[a] - p[b]);
  return areas / (6 * six_volumes) * std::sqrt(2.0) / std::sqrt(edges / 6);
}

namespace {

class disjoint_sets {
public:
  explicit disjoint_sets(std::size_t n) : parent_(n), size_(n, 1) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t n) {
    while (parent_[n] != n)
      n = parent_[n] = parent_[parent_[n]];
    return n;
  }

  void join(std::uint32_t a, std::uint32_t b, std::uint32_t most) {
    a = find(a);
    b = find(b);
    if (a == b || size_[a] + size_[b] > most)
      return;
    parent_[b] = a;
    size_[a] += size_[b];
  }

  [[nodiscard]] std::uint32_t size(std::uint32_t root) const { return size_[root]; }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> size_;
};

std::vector<std::pair<double, std::uint32_t>> thin_tets(const problem& p, double condition) {
  if (condition <= 0)
    return {};
  std::vector<double> of(p.element_count());
  parallel_for(of.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e) {
      const auto* n = &p.element_nodes[p.nodes_per_element * e];
      of[e] = tet_condition({p.nodes[n[0]], p.nodes[n[1]], p.nodes[n[2]], p.nodes[n[3]]});
    }
  });
  std::vector<std::pair<double, std::uint32_t>> result;
  polled_for(of.size(), [&](std::size_t e) {
    if (of[e] > condition)
      result.emplace_back(-of[e], static_cast<std::uint32_t>(e));
  });
  polled_sort(result, std::less{});
  return result;
}

}  // namespace

std::vector<std::uint8_t> wholly_held(std::span<const std::array<double, 6>> filter) {
  std::vector<std::uint8_t> result(filter.size());
  parallel_for(filter.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      result[n] = is_held(filter[n]) ? 1 : 0;
  });
  return result;
}

sliver_clusters cluster_slivers(const problem& p, const std::vector<std::uint8_t>& excluded,
                                std::uint32_t most, double condition) {
  sliver_clusters result;
  const auto thin = thin_tets(p, condition);
  if (thin.empty())
    return result;
  const std::size_t nodes = excluded.size();
  disjoint_sets sets(nodes);
  for (const auto& [negated, e] : thin) {
    std::uint32_t before = no_id;
    for (int a = 0; a < p.nodes_per_element; ++a) {
      const auto node = p.element_nodes[p.nodes_per_element * e + a];
      if (node >= nodes || excluded[node] != 0)
        continue;
      if (before != no_id)
        sets.join(before, node, most);
      before = node;
    }
  }
  result.of.assign(nodes, no_id);
  std::vector<std::uint32_t> number(nodes, no_id);
  polled_for(nodes, [&](std::size_t n) {
    const auto root = sets.find(static_cast<std::uint32_t>(n));
    if (excluded[n] != 0 || sets.size(root) < 2)
      return;
    if (number[root] == no_id)
      number[root] = result.count++;
    result.of[n] = number[root];
  });
  return result;
}

namespace {

/// The thin tets around nodes, worst first.
std::vector<std::pair<double, std::uint32_t>> thin_tets_around(
  const problem& p, std::span<const std::uint32_t> nodes, double condition,
  const std::function<std::vector<std::uint32_t>(std::uint32_t node)>& elements_at) {
  if (condition <= 0)
    return {};
  std::vector<std::uint32_t> elements;
  for (const auto n : nodes) {
    const auto around = elements_at(n);
    elements.insert(elements.end(), around.begin(), around.end());
  }
  sort_unique(elements);
  std::vector<std::pair<double, std::uint32_t>> result;
  for (const auto e : elements) {
    const auto* n = &p.element_nodes[p.nodes_per_element * std::size_t{e}];
    const double of = tet_condition({p.nodes[n[0]], p.nodes[n[1]], p.nodes[n[2]], p.nodes[n[3]]});
    if (of > condition)
      result.emplace_back(-of, e);
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace

cluster_change recluster(
  const problem& p, std::span<const std::uint32_t> nodes,
  const std::function<bool(std::uint32_t node)>& excluded,
  const std::function<std::vector<std::uint32_t>(std::uint32_t node)>& elements_at,
  const std::function<std::span<const std::uint32_t>(std::uint32_t cluster)>& members_of,
  std::uint32_t most, double condition, sliver_clusters& clusters) {
  cluster_change result;
  result.nodes.assign(nodes.begin(), nodes.end());
  for (const auto n : nodes)
    if (n < clusters.of.size() && clusters.of[n] != no_id)
      result.clusters.push_back(clusters.of[n]);
  sort_unique(result.clusters);
  for (const auto c : result.clusters)
    for (const auto n : members_of(c))
      result.nodes.push_back(n);
  sort_unique(result.nodes);
  const auto thin = thin_tets_around(p, result.nodes, condition, elements_at);
  if (thin.empty() && result.clusters.empty())
    return result;
  const auto place = [&](std::uint32_t node) {
    const auto found = std::ranges::lower_bound(result.nodes, node);
    return found == result.nodes.end() || *found != node || excluded(node)
             ? no_id
             : static_cast<std::uint32_t>(found - result.nodes.begin());
  };
  disjoint_sets sets(result.nodes.size());
  for (const auto& [negated, e] : thin) {
    std::uint32_t before = no_id;
    for (int a = 0; a < p.nodes_per_element; ++a) {
      const auto at = place(p.element_nodes[p.nodes_per_element * std::size_t{e} + a]);
      if (at == no_id)
        continue;
      if (before != no_id)
        sets.join(before, at, most);
      before = at;
    }
  }
  result.members.resize(result.clusters.size());
  std::vector<std::uint32_t> number(result.nodes.size(), no_id);
  std::uint32_t used = 0;
  clusters.of.resize(std::max<std::size_t>(clusters.of.size(), result.nodes.back() + 1), no_id);
  for (std::uint32_t i = 0; i < result.nodes.size(); ++i) {
    clusters.of[result.nodes[i]] = no_id;
    const auto root = sets.find(i);
    if (sets.size(root) < 2)
      continue;
    if (number[root] == no_id) {
      number[root] = used++;
      if (used > result.clusters.size()) {
        result.clusters.push_back(clusters.count++);
        result.members.emplace_back();
      }
    }
    clusters.of[result.nodes[i]] = result.clusters[number[root]];
    result.members[number[root]].push_back(result.nodes[i]);
  }
  return result;
}

}  // namespace tedit::fem
