// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/surface_guard.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "mesh/face_key.hpp"

namespace tedit {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A new facet must face at least so far (cosine) where the old ones did.
constexpr double least_cosine = 0.2;

vec3 area_of(const triangle& t) {
  return 0.5 * cross(t[1] - t[0], t[2] - t[0]);
}

double distance_to_segment(vec3 p, vec3 a, vec3 b) {
  const vec3 along = b - a;
  const double square = dot(along, along);
  const double s = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return norm(p - (a + s * along));
}

double distance_to_triangle(vec3 p, const triangle& t) {
  const vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double square = dot(n, n);
  double rim = unbounded;
  bool inside = square > 0;
  for (int i = 0; i < 3; ++i) {
    const vec3 a = t[i];
    const vec3 b = t[(i + 1) % 3];
    inside = inside && dot(cross(b - a, p - a), n) >= 0;
    rim = std::min(rim, distance_to_segment(p, a, b));
  }
  return inside ? std::min(rim, std::abs(dot(p - t[0], n)) / std::sqrt(square)) : rim;
}

bool has_corner(std::span<const triangle> patch, vec3 p) {
  return std::ranges::any_of(patch,
                             [&](const triangle& t) { return std::ranges::count(t, p) > 0; });
}

/// The largest distance of the first patch's corners from the second.
double corners_off(std::span<const triangle> from, std::span<const triangle> to) {
  double result = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    for (const auto p : from[i]) {
      // Corners that both have are off by nothing, those of several triangles looked at once.
      if (has_corner(to, p) || has_corner(from.first(i), p))
        continue;
      double nearest = unbounded;
      for (const auto& other : to)
        nearest = std::min(nearest, distance_to_triangle(p, other));
      result = std::max(result, nearest);
    }
  return result;
}

/// How far apart two edges are, along n, where they cross seen along n; 0 when they do not.
double gap_at_crossing(vec3 a, vec3 b, vec3 c, vec3 d, vec3 n) {
  const vec3 u = b - a;
  const vec3 v = d - c;
  const double turn = dot(cross(u, v), n);
  const double lengths = std::sqrt(dot(u, u) * dot(v, v));
  if (!(std::abs(turn) > 1e-9 * lengths))
    return 0;
  const double s = dot(cross(c - a, v), n) / turn;
  const double r = dot(cross(c - a, u), n) / turn;
  if (s < 0 || s > 1 || r < 0 || r > 1)
    return 0;
  return std::abs(dot((a + s * u) - (c + r * v), n));
}

/// The thickness of triangles that go without a successor: they close to their longest edges.
double thickness(const std::vector<triangle>& patch) {
  double result = 0;
  for (const auto& t : patch) {
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, norm(t[(i + 1) % 3] - t[i]));
    if (longest > 0)
      result = std::max(result, 2 * norm(area_of(t)) / longest);
  }
  return result;
}

struct patch_pair {
  std::vector<triangle> before;
  std::vector<triangle> after;
};

}  // namespace

double patch_distance(const std::vector<triangle>& before, const std::vector<triangle>& after) {
  vec3 n;
  for (const auto& t : before)
    n += area_of(t);
  if (!(norm(n) > 0))
    return unbounded;
  n = normalized(n);
  for (const auto& t : after) {
    const vec3 area = area_of(t);
    if (!(dot(area, n) > least_cosine * norm(area)))
      return unbounded;
  }
  double result = std::max(corners_off(before, after), corners_off(after, before));
  for (const auto& s : before)
    for (const auto& t : after)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result = std::max(result, gap_at_crossing(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3], n));
  return result;
}

void facets_at(const work_mesh& mesh, std::uint32_t v, const std::vector<std::uint32_t>& star,
               std::vector<fan_facet>& result) {
  result.clear();
  for (const auto t : star) {
    const auto& corner = mesh.tet_at(t);
    for (int face = 0; face < 4; ++face) {
      const auto beyond = mesh.behind(t)[face];
      if (corner[face] == v || !is_facet(beyond) || beyond == work_mesh::wall)
        continue;
      const auto& order = tet_faces[face];
      const std::array<std::uint32_t, 3> c{corner[order[0]], corner[order[1]], corner[order[2]]};
      const auto place = std::ranges::find(c, v) - c.begin();
      result.push_back({beyond & ~facet_flag, c[(place + 1) % 3], c[(place + 2) % 3]});
    }
  }
}

double surface_guard::allowed(const std::vector<triangle>& patch) const {
  double sum = 0;
  for (const auto& t : patch)
    for (int i = 0; i < 3; ++i)
      sum += norm(t[(i + 1) % 3] - t[i]);
  const double mean = patch.empty() ? 0 : sum / (3.0 * static_cast<double>(patch.size()));
  return tolerance_.absolute + tolerance_.relative * mean;
}

bool surface_guard::has_other_facet(surface_id surface, const work_change& change) const {
  const std::set<std::uint32_t> removed(change.removed.begin(), change.removed.end());
  for (std::uint32_t t = 0; t < mesh_.tet_slots(); ++t) {
    if (!mesh_.is_live(t) || removed.contains(t))
      continue;
    for (const auto beyond : mesh_.behind(t))
      if (is_facet(beyond) && beyond != work_mesh::wall &&
          mesh_.surface_of(beyond & ~facet_flag) == surface)
        return true;
  }
  return false;
}

bool surface_guard::admits(work_change& change) const {
  std::set<std::array<std::uint32_t, 3>> kept;
  for (const auto& corner : change.added)
    for (int face = 0; face < 4; ++face)
      kept.insert(make_face_key(tet{corner}, face).v);
  std::map<surface_id, patch_pair> patches;
  std::vector<triangle> all;
  double before = 0;
  for (const auto t : change.removed)
    for (int face = 0; face < 4; ++face) {
      const auto beyond = mesh_.behind(t)[face];
      const auto& c = mesh_.tet_at(t);
      if (!is_facet(beyond) || beyond == work_mesh::wall ||
          kept.contains(make_face_key(tet{c}, face).v))
        continue;
      const auto f = beyond & ~facet_flag;
      const auto& order = tet_faces[face];
      all.push_back({mesh_.at(c[order[0]]), mesh_.at(c[order[1]]), mesh_.at(c[order[2]])});
      patches[mesh_.surface_of(f)].before.push_back(all.back());
      before = std::max(before, mesh_.deviation_of(f));
    }
  for (const auto& f : change.facets) {
    triangle t{mesh_.at(f.v[0]), mesh_.at(f.v[1]), mesh_.at(f.v[2])};
    auto& patch = patches[f.surface];
    // The corners of a hint stand in any order: turned to where the old facets face.
    vec3 n;
    for (const auto& old : patch.before)
      n += area_of(old);
    if (dot(area_of(t), n) < 0)
      std::swap(t[1], t[2]);
    patch.after.push_back(t);
  }
  double moved = 0;
  for (const auto& [surface, patch] : patches) {
    if (patch.after.empty() && !has_other_facet(surface, change))
      return false;
    moved = std::max(moved, patch.after.empty() ? thickness(patch.before)
                                                : patch_distance(patch.before, patch.after));
  }
  change.deviation = before + moved;
  return change.deviation <= allowed(all);
}

bool surface_guard::admits_move(std::uint32_t v, const std::vector<fan_facet>& fan, vec3 to,
                                double& deviation) const {
  std::map<surface_id, patch_pair> patches;
  std::vector<triangle> all;
  double before = 0;
  for (const auto& f : fan) {
    auto& patch = patches[mesh_.surface_of(f.facet)];
    all.push_back({mesh_.at(v), mesh_.at(f.j), mesh_.at(f.k)});
    patch.before.push_back(all.back());
    patch.after.push_back({to, mesh_.at(f.j), mesh_.at(f.k)});
    before = std::max(before, mesh_.deviation_of(f.facet));
  }
  double moved = 0;
  for (const auto& [surface, patch] : patches)
    moved = std::max(moved, patch_distance(patch.before, patch.after));
  deviation = before + moved;
  return deviation <= allowed(all);
}

namespace {

/// The neighbours of v over which its facets change their surface.
std::vector<std::uint32_t> crease_neighbours(const work_mesh& mesh,
                                             const std::vector<fan_facet>& fan) {
  std::map<std::uint32_t, std::vector<surface_id>> at;
  for (const auto& f : fan) {
    at[f.j].push_back(mesh.surface_of(f.facet));
    at[f.k].push_back(mesh.surface_of(f.facet));
  }
  std::vector<std::uint32_t> result;
  for (const auto& [u, surfaces] : at)
    if (surfaces.size() != 2 || surfaces[0] != surfaces[1])
      result.push_back(u);
  return result;
}

std::set<surface_id> surfaces_at(const work_mesh& mesh, const std::vector<fan_facet>& fan) {
  std::set<surface_id> result;
  for (const auto& f : fan)
    result.insert(mesh.surface_of(f.facet));
  return result;
}

}  // namespace

std::vector<vec3> surface_guard::free_directions(std::uint32_t v,
                                                 const std::vector<fan_facet>& fan) const {
  const auto count = surfaces_at(mesh_, fan).size();
  if (count == 1) {
    vec3 n;
    for (const auto& f : fan)
      n += area_of({mesh_.at(v), mesh_.at(f.j), mesh_.at(f.k)});
    n = normalized(n);
    if (n == vec3{})
      return {};
    const vec3 axis = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    const vec3 u = normalized(cross(n, axis));
    return {u, cross(n, u)};
  }
  const auto crease = crease_neighbours(mesh_, fan);
  if (count != 2 || crease.size() != 2)
    return {};
  return {normalized(mesh_.at(crease[1]) - mesh_.at(crease[0]))};
}

bool surface_guard::may_collapse(std::uint32_t v, std::uint32_t u,
                                 const std::vector<std::uint32_t>& star,
                                 const std::vector<fan_facet>& fan) const {
  if (mesh_.kind(u) != vertex_kind::boundary)
    return false;                  // What lies beyond a wall cannot be looked at.
  std::set<std::uint32_t> shared;  // By facets v-u-w.
  for (const auto& f : fan)
    if (f.j == u || f.k == u)
      shared.insert(f.j == u ? f.k : f.j);
  if (shared.size() != 2)
    return false;
  // The link condition: what both see, they see over a tet or facet that has both.
  std::vector<std::uint32_t> other_star;
  mesh_.star(u, other_star);
  std::set<std::uint32_t> near_v, near_u, over_edge, rim_u;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_v, edges_u, edges_both;
  const auto collect = [&](const std::vector<std::uint32_t>& tets, std::uint32_t self,
                           std::uint32_t other, auto& near, auto& edges) {
    for (const auto t : tets) {
      const auto& c = mesh_.tet_at(t);
      const bool both = std::ranges::count(c, other) > 0;
      for (int i = 0; i < 4; ++i) {
        if (c[i] == self)
          continue;
        near.insert(c[i]);
        if (both && c[i] != other)
          over_edge.insert(c[i]);
        for (int j = i + 1; j < 4; ++j)
          if (c[j] != self) {
            const auto edge = std::minmax(c[i], c[j]);
            edges.insert(edge);
            if (both && c[i] != other && c[j] != other)
              edges_both.insert(edge);
          }
      }
    }
  };
  collect(star, v, u, near_v, edges_v);
  collect(other_star, u, v, near_u, edges_u);
  for (const auto w : near_v)
    if (w != u && near_u.contains(w) && !over_edge.contains(w))
      return false;
  for (const auto& edge : edges_v)
    if (edge.first != u && edge.second != u && edges_u.contains(edge) && !edges_both.contains(edge))
      return false;
  std::vector<fan_facet> other_fan;
  facets_at(mesh_, u, other_star, other_fan);
  for (const auto& f : other_fan)
    rim_u.insert({f.j, f.k});
  for (const auto& f : fan)
    for (const auto w : {f.j, f.k})
      if (w != u && rim_u.contains(w) && !shared.contains(w))
        return false;
  return true;
}

}  // namespace tedit
