// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/fill_hole/rims.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::ops {

boundary_edges::boundary_edges(const mesh_version& mesh) {
  facets_.reserve(3 * mesh.facet_count());
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& v = mesh.facet(f).v;
    for (int i = 0; i < 3; ++i) {
      const auto [at, fresh] = facets_.emplace(key(v[i], v[(i + 1) % 3]), f);
      if (!fresh)
        at->second = no_id;
    }
  }
}

facet_id boundary_edges::left_of(vertex_id a, vertex_id b) const {
  const auto found = facets_.find(key(a, b));
  return found == facets_.end() ? no_id : found->second;
}

std::string rim::name() const {
  char text[128];
  std::snprintf(text, sizeof(text), "the rim at (%.4g, %.4g, %.4g) mm with radius %.4g mm",
                1e3 * centre.x, 1e3 * centre.y, 1e3 * centre.z, 1e3 * radius);
  return text;
}

namespace {

class rim_walker {
public:
  rim_walker(const mesh_version& mesh, const boundary_edges& edges,
             const std::unordered_set<facet_id>& selected)
      : mesh_(mesh), edges_(edges), selected_(selected) {}

  /// All rims of one shell's facets.
  expected<std::vector<rim>> walk(const std::vector<facet_id>& facets) {
    std::vector<rim> rims;
    std::unordered_set<std::uint64_t> done;
    for (const auto f : facets) {
      for (int i = 0; i < 3; ++i) {
        const auto a = mesh_.facet(f).v[i];
        const auto b = mesh_.facet(f).v[(i + 1) % 3];
        if (!is_rim_edge(a, b) || done.contains(std::uint64_t{a} << 32 | b))
          continue;
        auto found = follow(f, a, b, done);
        if (!found)
          return fail(found.error());
        measure(*found);
        rims.push_back(std::move(*found));
      }
    }
    return rims;
  }

private:
  [[nodiscard]] bool is_rim_edge(vertex_id a, vertex_id b) const {
    return !selected_.contains(edges_.left_of(b, a));
  }

  [[nodiscard]] vertex_id after(facet_id f, vertex_id v) const {
    const auto& c = mesh_.facet(f).v;
    return c[(std::ranges::find(c, v) - c.begin() + 1) % 3];
  }

  expected<rim> follow(facet_id f, vertex_id a, vertex_id b,
                       std::unordered_set<std::uint64_t>& done) const {
    rim result;
    const auto start = std::pair(a, b);
    do {
      const auto across = edges_.left_of(b, a);
      if (across == no_id)
        return fail(ec::non_manifold,
                    "the boundary is not a clean surface at edge " + std::to_string(a) + "-" +
                      std::to_string(b),
                    "Repair the mesh there first");
      done.insert(std::uint64_t{a} << 32 | b);
      result.loop.push_back(a);
      result.inner.push_back(f);
      result.outer.push_back(across);
      // Turn around b inside the selected fan until an edge with an unselected far side leaves b.
      vertex_id c = after(f, b);
      for (std::size_t turns = 0; !is_rim_edge(b, c); ++turns) {
        f = edges_.left_of(c, b);
        c = after(f, b);
        if (turns > mesh_.facet_count())
          return fail(ec::internal, "a rim does not close");
      }
      a = b;
      b = c;
      if (result.loop.size() > mesh_.facet_count() * 3ul)
        return fail(ec::internal, "a rim does not close");
    } while (std::pair(a, b) != start);
    return result;
  }

  /// Angle through the material at the edge from a to b of `inner`, rad: 90 degrees at the mouth of
  /// a drilled hole, 270 at its flat bottom.
  [[nodiscard]] double material_angle(facet_id inner, facet_id outer, vertex_id a,
                                      vertex_id b) const {
    const vec3 n1 = normalized(area_vector(mesh_, mesh_.facet(inner)));
    const vec3 n2 = normalized(area_vector(mesh_, mesh_.facet(outer)));
    const vec3 along = normalized(mesh_.position(b) - mesh_.position(a));
    return std::numbers::pi - std::atan2(dot(along, cross(n1, n2)), dot(n1, n2));
  }

  void measure(rim& r) const {
    const std::size_t n = r.loop.size();
    vec3 sum;
    double length = 0;
    double concave = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const vec3 p = mesh_.position(r.loop[i]);
      const vec3 next = mesh_.position(r.loop[(i + 1) % n]);
      r.centre += p / static_cast<double>(n);
      const double edge = norm(next - p);
      length += edge;
      if (material_angle(r.inner[i], r.outer[i], r.loop[i], r.loop[(i + 1) % n]) >=
          std::numbers::pi * 179 / 180)
        concave += edge;
    }
    for (std::size_t i = 0; i < n; ++i)
      sum +=
        cross(mesh_.position(r.loop[i]) - r.centre, mesh_.position(r.loop[(i + 1) % n]) - r.centre);
    r.normal = normalized(sum);
    r.mean_edge = length / static_cast<double>(n);
    r.concave_share = concave / length;
    for (const auto v : r.loop) {
      const vec3 d = mesh_.position(v) - r.centre;
      r.radius = std::max(r.radius, norm(d));
      r.deviation = std::max(r.deviation, std::abs(dot(d, r.normal)));
    }
  }

  const mesh_version& mesh_;
  const boundary_edges& edges_;
  const std::unordered_set<facet_id>& selected_;
};

}  // namespace

expected<std::vector<shell>> find_shells(const mesh_version& mesh, const boundary_edges& edges,
                                         const std::vector<facet_id>& selected) {
  const std::unordered_set<facet_id> set(selected.begin(), selected.end());
  std::unordered_set<facet_id> seen;
  std::vector<shell> shells;
  rim_walker walker(mesh, edges, set);
  for (const auto seed : selected) {
    if (!seen.insert(seed).second)
      continue;
    shell part;
    part.facets.push_back(seed);
    for (std::size_t next = 0; next < part.facets.size(); ++next) {
      const auto v = mesh.facet(part.facets[next]).v;
      for (int i = 0; i < 3; ++i) {
        const auto across = edges.left_of(v[(i + 1) % 3], v[i]);
        if (set.contains(across) && seen.insert(across).second)
          part.facets.push_back(across);
      }
    }
    auto rims = walker.walk(part.facets);
    if (!rims)
      return fail(rims.error());
    part.rims = std::move(*rims);
    shells.push_back(std::move(part));
  }
  return shells;
}

}  // namespace tedit::ops
