// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/boundary_patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <span>
#include <tuple>

#include "mesh/box.hpp"
#include "mesh/place_text.hpp"

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

/// Separate bodies: tets that hang together over faces.
std::size_t count_bodies(const std::vector<tet>& tets, const std::vector<adjacency>& neighbours) {
  disjoint_sets bodies(tets.size());
  for (tet_id t = 0; t < tets.size(); ++t)
    for (const auto behind : neighbours[t])
      if (!is_facet(behind))
        bodies.unite(t, behind);
  std::size_t count = 0;
  for (tet_id t = 0; t < tets.size(); ++t)
    count += bodies.find(t) == t;
  return count;
}

/// Patches that edges of more than 30 degrees part, whatever the surfaces' ids.
std::size_t count_smooth_patches(const std::vector<boundary_facet>& facets,
                                 const std::vector<facet_edge>& edges,
                                 const std::vector<vec3>& positions) {
  disjoint_sets patches(facets.size());
  for_each_edge(edges, [&](std::span<const facet_edge> group) {
    for (std::size_t i = 1; i < group.size(); ++i)
      if (smooth(facets[group[0].facet], facets[group[i].facet], positions))
        patches.unite(group[0].facet, group[i].facet);
  });
  std::size_t count = 0;
  for (facet_id f = 0; f < facets.size(); ++f)
    count += patches.find(f) == f;
  return count;
}

/// Vertices of the boundary that lie on another one, and the box around them.
struct coincidence {
  std::size_t vertices = 0;
  box around;
};

/// Vertices count as one place within 1e-7 of the part's size, and well within its shortest edge.
double coincidence_tolerance(const std::vector<facet_edge>& edges,
                             const std::vector<vec3>& positions) {
  box whole;
  double shortest = std::numeric_limits<double>::max();
  for (const auto& e : edges) {
    whole.add(positions[e.a]);
    whole.add(positions[e.b]);
    shortest = std::min(shortest, norm(positions[e.b] - positions[e.a]));
  }
  return std::min(1e-7 * norm(whole.high - whole.low), 0.01 * shortest);
}

/// Places are sorted along an oblique line, to which no plane of a part is square: few others lie
/// near a place there.
coincidence find_coincident(const std::vector<facet_edge>& edges,
                            const std::vector<vec3>& positions) {
  const vec3 along = normalized({1, std::numbers::sqrt2, std::numbers::sqrt3});
  const double tolerance = coincidence_tolerance(edges, positions);
  std::vector<std::pair<double, vertex_id>> order;
  std::vector<bool> listed(positions.size(), false);
  for (const auto& e : edges)
    for (const auto v : {e.a, e.b})
      if (!listed[v]) {
        listed[v] = true;
        order.emplace_back(dot(positions[v], along), v);
      }
  std::ranges::sort(order);
  std::vector<bool> found(order.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first <= tolerance;
         ++j)
      if (norm(positions[order[j].second] - positions[order[i].second]) <= tolerance)
        found[i] = found[j] = true;
  coincidence result;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (found[i]) {
      ++result.vertices;
      result.around.add(positions[order[i].second]);
    }
  return result;
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
                                           const std::vector<vec3>& positions) {
  std::vector<std::string> sentences;
  const auto edges = sorted_edges(facets);
  std::size_t bad_edges = 0;
  for_each_edge(edges, [&](std::span<const facet_edge> group) { bad_edges += group.size() != 2; });
  if (bad_edges > 0)
    sentences.push_back("the boundary touches itself along " + std::to_string(bad_edges) +
                        " edges (more than two boundary facets meet there)");
  if (const auto contacts = count_boundary_contacts(facets, edges, positions.size()); contacts > 0)
    sentences.push_back("the boundary touches itself at " + std::to_string(contacts) +
                        " vertices: parts that meet in a vertex only are hinged, not joined");
  if (const auto count = count_bodies(tets, neighbours); count > 1)
    sentences.push_back("the mesh consists of " + std::to_string(count) + " separate bodies");
  if (const auto found = find_coincident(edges, positions); found.vertices > 0)
    sentences.push_back(std::to_string(found.vertices) +
                        " nodes lie at the place of another node, from " +
                        place_text(found.around.low) + " to " + place_text(found.around.high) +
                        ", and are not merged: what touches there is not joined, and no force "
                        "passes. Merge them where it should be one part (in Gmsh: Coherence)");
  const auto same = [&](const boundary_facet& f) { return f.surface == facets[0].surface; };
  if (std::ranges::all_of(facets, same))
    if (const auto patches = count_smooth_patches(facets, edges, positions); patches > 1)
      sentences.push_back("all boundary faces have the surface id " +
                          std::to_string(facets[0].surface) +
                          ", though edges sharper than 30 "
                          "degrees part them into " +
                          std::to_string(patches) +
                          " patches: only the whole boundary can be picked. Save the faces of the "
                          "CAD model as surfaces, or leave the triangles out of the file to have "
                          "it split at those edges");
  return sentences;
}

}  // namespace tedit
