// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/level_set_freedom.hpp"

#include <algorithm>
#include <cmath>

namespace tedit {

namespace {

/// Deviations up to this share of the facets' size are rounding of a CAD file, not shape.
constexpr double flatness = 1e-6;

/// Facets of one surface around a vertex, as long as they lie in one plane.
struct flat_fan {
  surface_id surface = 0;
  vec3 area;  ///< Sum of area vectors.
  bool flat = true;
};

std::vector<flat_fan> fans_at(const mesh_builder& mesh, vertex_id v,
                              const std::vector<facet_id>& around) {
  std::vector<flat_fan> fans;
  const auto fan_of = [&](surface_id id) {
    return std::ranges::find(fans, id, &flat_fan::surface);
  };
  for (const auto f : around) {
    const auto& facet = mesh.facet(f);
    auto fan = fan_of(facet.surface);
    if (fan == fans.end())
      fan = fans.insert(fans.end(), {facet.surface, {}, true});
    fan->area +=
      area_vector(mesh.position(facet.v[0]), mesh.position(facet.v[1]), mesh.position(facet.v[2]));
  }
  const vec3 centre = mesh.position(v);
  for (const auto f : around) {
    const auto& facet = mesh.facet(f);
    const auto fan = fan_of(facet.surface);
    const vec3 n = normalized(fan->area);
    for (const auto u : facet.v) {
      const vec3 d = mesh.position(u) - centre;
      fan->flat = fan->flat && std::abs(dot(d, n)) <= flatness * norm(d);
    }
  }
  return fans;
}

/// The ends of the edges at v between two surfaces.
std::vector<vertex_id> border_ends(const mesh_builder& mesh, vertex_id v,
                                   const std::vector<facet_id>& around) {
  std::vector<std::pair<vertex_id, surface_id>> ends;
  for (const auto f : around)
    for (const auto u : mesh.facet(f).v)
      if (u != v)
        ends.emplace_back(u, mesh.facet(f).surface);
  std::ranges::sort(ends);
  std::vector<vertex_id> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i].first == ends[i + 1].first && ends[i].second != ends[i + 1].second)
      result.push_back(ends[i].first);
  return result;
}

double squared(vec3 a) {
  return dot(a, a);
}

/// Distance of a point from a triangle, m.
double distance_to(vec3 p, vec3 a, vec3 b, vec3 c) {
  const vec3 n = cross(b - a, c - a);
  const auto side = [&](vec3 from, vec3 to) { return dot(cross(to - from, p - from), n); };
  if (side(a, b) >= 0 && side(b, c) >= 0 && side(c, a) >= 0)
    return std::abs(dot(p - a, normalized(n)));
  const auto to_edge = [&](vec3 from, vec3 to) {
    const double t = std::clamp(dot(p - from, to - from) / squared(to - from), 0.0, 1.0);
    return norm(p - from - t * (to - from));
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

}  // namespace

bool vertex_freedom::allows(vec3 step) const {
  return norm(step - project(step)) <= flatness * norm(step);
}

vec3 vertex_freedom::project(vec3 step) const {
  if (dimensions == 3)
    return step;
  if (dimensions == 0)
    return {};
  const vec3 along = dot(step, axis) * axis;
  return dimensions == 1 ? along : step - along;
}

std::vector<facet_id> facets_at(const mesh_builder& mesh, vertex_id v,
                                const std::vector<tet_id>& star) {
  std::vector<facet_id> result;
  for (const auto t : star)
    for (int i = 0; i < 4; ++i)
      if (mesh.tet_at(t).v[i] != v && is_facet(mesh.neighbours(t)[i]))
        result.push_back(mesh.neighbours(t)[i] & ~facet_flag);
  return result;
}

bool may_merge(const mesh_builder& mesh, vertex_id from, vertex_id to,
               const std::vector<tet_id>& star, double tolerance) {
  for (const auto t : star)
    if (mesh.region_of(t) != mesh.region_of(star.front()))
      return false;
  const auto around = facets_at(mesh, from, star);
  const auto fans = fans_at(mesh, from, around);
  const vec3 step = mesh.position(to) - mesh.position(from);
  if (fans.empty() || fans.size() > 2 || std::ranges::any_of(fans, [&](const flat_fan& fan) {
        return fan.flat && std::abs(dot(step, normalized(fan.area))) > flatness * norm(step);
      }))
    return false;
  if (fans.size() == 2 && !std::ranges::count(border_ends(mesh, from, around), to))
    return false;
  double longest = 0;
  double nearest = 1e300;
  std::size_t shared = 0;
  for (const auto f : around) {
    std::array<vec3, 3> p;
    bool vanishes = false;
    for (int i = 0; i < 3; ++i) {
      const auto v = mesh.facet(f).v[i];
      vanishes = vanishes || v == to;
      longest = std::max(longest, norm(mesh.position(v) - mesh.position(from)));
      p[i] = mesh.position(v == from ? to : v);
    }
    shared += vanishes;
    if (vanishes)
      continue;
    const auto& v = mesh.facet(f).v;
    const vec3 before = area_vector(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]));
    const vec3 after = area_vector(p[0], p[1], p[2]);
    if (dot(before, after) < 0.7 * norm(before) * norm(after))
      return false;
    nearest = std::min(nearest, distance_to(mesh.position(from), p[0], p[1], p[2]));
  }
  return shared == 2 && nearest <= tolerance * longest;
}

vertex_freedom freedom_of(const mesh_builder& mesh, vertex_id v, const std::vector<tet_id>& star) {
  for (const auto t : star)
    if (mesh.region_of(t) != mesh.region_of(star.front()))
      return {};
  const auto around = facets_at(mesh, v, star);
  if (around.empty())
    return {3, {}};
  const auto fans = fans_at(mesh, v, around);
  if (fans.size() > 2 || !std::ranges::all_of(fans, &flat_fan::flat))
    return {};
  const auto ends = border_ends(mesh, v, around);
  if (fans.size() == 1)
    return {2, normalized(fans.front().area)};
  if (ends.size() != 2)
    return {};
  const vec3 a = normalized(mesh.position(ends[0]) - mesh.position(v));
  const vec3 b = normalized(mesh.position(ends[1]) - mesh.position(v));
  if (norm(a + b) > flatness)
    return {};
  return {1, a};
}

}  // namespace tedit
