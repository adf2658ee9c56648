// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/boundary_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <span>
#include <tuple>

namespace tedit {

namespace {

/// Sets with union by index: the smallest member names its set.
class disjoint_sets {
public:
  explicit disjoint_sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> parent_;
};

struct facet_edge {
  vertex_id a;
  vertex_id b;
  facet_id facet;
};

/// All edges of all facets, those of one mesh edge side by side.
std::vector<facet_edge> sorted_edges(const std::vector<boundary_facet>& facets) {
  std::vector<facet_edge> edges;
  edges.reserve(3 * facets.size());
  for (facet_id f = 0; f < facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(facets[f].v[i], facets[f].v[(i + 1) % 3]);
      edges.push_back({a, b, f});
    }
  }
  std::ranges::sort(edges, {}, [](const facet_edge& e) { return std::tuple(e.a, e.b, e.facet); });
  return edges;
}

template <class Visit>
void for_each_edge(const std::vector<facet_edge>& edges, Visit&& visit) {
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].a == edges[first].a &&
           edges[last].b == edges[first].b)
      ++last;
    visit(std::span<const facet_edge>(&edges[first], last - first));
  }
}

bool smooth(const boundary_facet& f, const boundary_facet& g, const std::vector<vec3>& p) {
  const auto normal = [&](const boundary_facet& t) {
    return normalized(cross(p[t.v[1]] - p[t.v[0]], p[t.v[2]] - p[t.v[0]]));
  };
  return dot(normal(f), normal(g)) > std::cos(std::numbers::pi / 6);
}

std::size_t count_boundary_contacts(const std::vector<boundary_facet>& facets,
                                    const std::vector<facet_edge>& edges, std::size_t vertices) {
  // Corners of facets joined over shared edges form fans; a vertex of a manifold has one.
  disjoint_sets corners(3 * facets.size());
  const auto corner = [&](facet_id f, vertex_id v) {
    const auto& c = facets[f].v;
    return static_cast<std::uint32_t>(3 * f + (std::ranges::find(c, v) - c.begin()));
  };
  for_each_edge(edges, [&](std::span<const facet_edge> group) {
    for (std::size_t i = 1; i < group.size(); ++i) {
      corners.unite(corner(group[0].facet, group[0].a), corner(group[i].facet, group[0].a));
      corners.unite(corner(group[0].facet, group[0].b), corner(group[i].facet, group[0].b));
    }
  });
  std::vector<std::uint32_t> fans(vertices, 0);
  std::size_t contacts = 0;
  for (facet_id f = 0; f < facets.size(); ++f)
    for (std::uint32_t i = 0; i < 3; ++i)
      if (corners.find(3 * f + i) == 3 * f + i && ++fans[facets[f].v[i]] == 2)
        ++contacts;
  return contacts;
}

}  // namespace

std::vector<surface_id> assign_missing_surfaces(std::vector<boundary_facet>& facets,
                                                const std::vector<bool>& has_surface,
                                                const std::vector<vec3>& positions,
                                                surface_id largest) {
  if (std::ranges::all_of(has_surface, [](bool has) { return has; }))
    return {};
  disjoint_sets patches(facets.size());
  const auto edges = sorted_edges(facets);
  for_each_edge(edges, [&](std::span<const facet_edge> group) {
    for (std::size_t i = 1; i < group.size(); ++i) {
      const auto f = group[0].facet;
      const auto g = group[i].facet;
      if (!has_surface[f] && !has_surface[g] && smooth(facets[f], facets[g], positions))
        patches.unite(f, g);
    }
  });
  // The surfaces that a patch continues smoothly.
  std::vector<std::set<surface_id>> around(facets.size());
  for_each_edge(edges, [&](std::span<const facet_edge> group) {
    for (const auto& mine : group)
      for (const auto& other : group)
        if (!has_surface[mine.facet] && has_surface[other.facet] &&
            smooth(facets[mine.facet], facets[other.facet], positions))
          around[patches.find(mine.facet)].insert(facets[other.facet].surface);
  });
  std::vector<surface_id> made;
  for (facet_id f = 0; f < facets.size(); ++f) {
    if (has_surface[f])
      continue;
    const auto first = patches.find(f);
    if (first != f) {
      facets[f].surface = facets[first].surface;
    } else if (around[f].size() == 1) {
      facets[f].surface = *around[f].begin();
    } else {
      facets[f].surface = ++largest;
      made.push_back(largest);
    }
  }
  return made;
}

std::vector<std::string> describe_boundary(const std::vector<boundary_facet>& facets,
                                           const std::vector<tet>& tets,
                                           const std::vector<adjacency>& neighbours,
                                           std::size_t vertices) {
  std::vector<std::string> sentences;
  const auto edges = sorted_edges(facets);
  std::size_t bad_edges = 0;
  for_each_edge(edges, [&](std::span<const facet_edge> group) { bad_edges += group.size() != 2; });
  if (bad_edges > 0)
    sentences.push_back("the boundary touches itself along " + std::to_string(bad_edges) +
                        " edges (more than two boundary facets meet there)");
  if (const auto contacts = count_boundary_contacts(facets, edges, vertices); contacts > 0)
    sentences.push_back("the boundary touches itself at " + std::to_string(contacts) +
                        " vertices: parts that meet in a vertex only are hinged, not joined");
  disjoint_sets bodies(tets.size());
  for (tet_id t = 0; t < tets.size(); ++t)
    for (const auto behind : neighbours[t])
      if (!is_facet(behind))
        bodies.unite(t, behind);
  std::size_t count = 0;
  for (tet_id t = 0; t < tets.size(); ++t)
    count += bodies.find(t) == t;
  if (count > 1)
    sentences.push_back("the mesh consists of " + std::to_string(count) + " separate bodies");
  return sentences;
}

}  // namespace tedit
