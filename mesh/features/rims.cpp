// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/rims.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include "base/units.hpp"
#include "mesh/place_text.hpp"

namespace tedit {

facet_id facet_across(const mesh_version& mesh, facet_id f, int edge) {
  const auto& facet = mesh.facet(f);
  const auto a = facet.v[edge];
  const auto b = facet.v[(edge + 1) % 3];
  auto t = facet.tet;
  // Each tet at the edge has two faces with it: enter by one, leave by the other, which lies
  // opposite the corner that the two do not share.
  auto leave = facet.v[(edge + 2) % 3];
  while (true) {
    const auto& corner = mesh.tet_at(t).v;
    int face = 0;
    auto other = no_id;
    for (int i = 0; i < 4; ++i) {
      if (corner[i] == leave)
        face = i;
      else if (corner[i] != a && corner[i] != b)
        other = corner[i];
    }
    const auto behind = mesh.neighbours(t)[face];
    if (is_facet(behind))
      return behind & ~facet_flag;
    t = behind;
    leave = other;
  }
}

double material_angle(const mesh_version& mesh, facet_id f, int edge) {
  const auto& facet = mesh.facet(f);
  const vec3 n1 = normalized(area_vector(mesh, facet));
  const vec3 n2 = normalized(area_vector(mesh, mesh.facet(facet_across(mesh, f, edge))));
  const vec3 along =
    normalized(mesh.position(facet.v[(edge + 1) % 3]) - mesh.position(facet.v[edge]));
  return std::numbers::pi - std::atan2(dot(along, cross(n1, n2)), dot(n1, n2));
}

std::string rim::name() const {
  char size[32];
  std::snprintf(size, sizeof(size), "%.4g mm", 1e3 * radius);
  return "the rim at " + place_text(centre) + " with radius " + size;
}

namespace {

class rim_walker {
public:
  rim_walker(const mesh_version& mesh, const std::unordered_set<facet_id>& selected)
      : mesh_(mesh), selected_(selected) {}

  /// All rims of one shell's facets.
  std::vector<rim> walk(const std::vector<facet_id>& facets) {
    std::vector<rim> rims;
    std::unordered_set<std::uint64_t> done;
    for (const auto f : facets) {
      for (int i = 0; i < 3; ++i) {
        if (done.contains(key(f, i)) || selected_.contains(facet_across(mesh_, f, i)))
          continue;
        rims.push_back(follow(f, i, done));
        measure(rims.back());
      }
    }
    return rims;
  }

private:
  static std::uint64_t key(facet_id f, int edge) { return std::uint64_t{f} << 2 | edge; }

  [[nodiscard]] int edge_from(facet_id f, vertex_id v) const {
    const auto& c = mesh_.facet(f).v;
    return static_cast<int>(std::ranges::find(c, v) - c.begin());
  }

  rim follow(facet_id f, int edge, std::unordered_set<std::uint64_t>& done) const {
    rim result;
    while (done.insert(key(f, edge)).second) {
      const auto& v = mesh_.facet(f).v;
      result.loop.push_back(v[edge]);
      result.inner.push_back(f);
      result.outer.push_back(facet_across(mesh_, f, edge));
      // Turn around the edge's end inside the selected fan until an edge leaves the selection.
      const auto pivot = v[(edge + 1) % 3];
      edge = (edge + 1) % 3;
      for (auto across = facet_across(mesh_, f, edge); selected_.contains(across);
           across = facet_across(mesh_, f, edge)) {
        f = across;
        edge = edge_from(f, pivot);
      }
    }
    return result;
  }

  void measure(rim& r) const {
    const std::size_t n = r.loop.size();
    vec3 sum;
    double length = 0;
    double concave = 0;
    double convex = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const vec3 p = mesh_.position(r.loop[i]);
      const vec3 next = mesh_.position(r.loop[(i + 1) % n]);
      r.centre += p / static_cast<double>(n);
      const double edge = norm(next - p);
      length += edge;
      const double angle =
        material_angle(mesh_, r.inner[i], edge_from(r.inner[i], r.loop[i])) / degree;
      concave += angle >= 179 ? edge : 0;
      convex += angle <= 181 ? edge : 0;
    }
    for (std::size_t i = 0; i < n; ++i)
      sum +=
        cross(mesh_.position(r.loop[i]) - r.centre, mesh_.position(r.loop[(i + 1) % n]) - r.centre);
    r.normal = normalized(sum);
    r.mean_edge = length / static_cast<double>(n);
    r.concave_share = concave / length;
    r.convex_share = convex / length;
    for (const auto v : r.loop) {
      const vec3 d = mesh_.position(v) - r.centre;
      r.radius = std::max(r.radius, norm(d));
      r.deviation = std::max(r.deviation, std::abs(dot(d, r.normal)));
    }
  }

  const mesh_version& mesh_;
  const std::unordered_set<facet_id>& selected_;
};

}  // namespace

std::vector<shell> find_shells(const mesh_version& mesh, const std::vector<facet_id>& selected) {
  const std::unordered_set<facet_id> set(selected.begin(), selected.end());
  std::unordered_set<facet_id> seen;
  std::vector<shell> shells;
  rim_walker walker(mesh, set);
  for (const auto seed : selected) {
    if (!seen.insert(seed).second)
      continue;
    shell part;
    part.facets.push_back(seed);
    for (std::size_t next = 0; next < part.facets.size(); ++next) {
      for (int i = 0; i < 3; ++i) {
        const auto across = facet_across(mesh, part.facets[next], i);
        if (set.contains(across) && seen.insert(across).second)
          part.facets.push_back(across);
      }
    }
    part.rims = walker.walk(part.facets);
    shells.push_back(std::move(part));
  }
  return shells;
}

}  // namespace tedit
