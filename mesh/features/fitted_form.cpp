// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/fitted_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/distances.hpp"

namespace tedit {

namespace {

/// Around the facets that meet a box so many rings are looked at: tools change two, and what is
/// fitted at a corner needs as many again.
constexpr int rings_around = 5;
/// A foot is found to a share of the facet's edge, or to rounding.
constexpr double foot_step = 1e-13;
constexpr double ulp = 2e-16;
constexpr int most_foot_steps = 12;
/// So many corners are looked at first, for how far the nearest facet is at most.
constexpr std::size_t first_looks = 32;

std::array<vec3, 3> points_of(const facet_corners& facets, const std::array<std::uint32_t, 3>& t) {
  return {facets.points[t[0]], facets.points[t[1]], facets.points[t[2]]};
}

bool has_all(const std::array<std::uint32_t, 3>& t, const std::vector<std::uint8_t>& of) {
  return std::ranges::all_of(t, [&](auto v) { return of[v] != 0; });
}

/// Of the facets that meet the box, and of the rings around them.
std::vector<std::uint8_t> corners_around(const facet_corners& facets, const box& within) {
  std::vector<std::uint8_t> result(facets.points.size());
  for (const auto& t : facets.triangles)
    if (within.meets(box_of(points_of(facets, t))))
      for (const auto v : t)
        result[v] = 1;
  for (int ring = 0; ring < rings_around; ++ring) {
    auto next = result;
    for (const auto& t : facets.triangles)
      if (std::ranges::any_of(t, [&](auto v) { return result[v] != 0; }))
        for (const auto v : t)
          next[v] = 1;
    result = std::move(next);
  }
  return result;
}

}  // namespace

fitted_form::fitted_form(facet_corners facets) : facets_(std::move(facets)), directions_(facets_) {
  std::vector<box> boxes;
  for (const auto& t : facets_.triangles)
    boxes.push_back(box_of(points_of(facets_, t)));
  tree_.emplace(boxes);
}

double fitted_form::radius_at(vec3 p) const {
  const auto& t = facets_.triangles[nearest_facet(p).triangle];
  const box all = tree_->extent();
  double least = norm(all.high - all.low);
  for (int i = 0; i < 3; ++i) {
    const auto& one = directions_.at(t[i]);
    const auto& other = directions_.at(t[(i + 1) % 3]);
    const double length = norm(facets_.points[t[(i + 1) % 3]] - facets_.points[t[i]]);
    if (one && other && norm(*one - *other) * least > length)
      least = length / norm(*one - *other);
  }
  return least;
}

std::shared_ptr<const fitted_form> fitted_form::through(const facet_corners& facets) {
  if (facets.triangles.empty())
    return nullptr;
  return std::shared_ptr<const fitted_form>(new fitted_form(facets));
}

std::shared_ptr<const fitted_form> fitted_form::near(const facet_corners& facets,
                                                     const box& within) {
  const auto is_near = corners_around(facets, within);
  std::vector<triangle_corners> some;
  for (const auto& t : facets.triangles)
    if (has_all(t, is_near))
      some.push_back(t);
  const auto made = through(with_own_points(facets.points, some));
  if (!made)
    return nullptr;
  const bool all_said = std::ranges::all_of(made->facets_.triangles, [&](const auto& t) {
    return !within.meets(box_of(points_of(made->facets_, t))) ||
           std::ranges::all_of(t, [&](auto v) { return made->directions_.at(v).has_value(); });
  });
  return all_said ? made : nullptr;
}

fitted_form::patch_point fitted_form::nearest_facet(vec3 p) const {
  patch_point best;
  double nearest = std::numeric_limits<double>::infinity();
  const std::size_t stride = 1 + facets_.triangles.size() / first_looks;
  for (std::size_t i = 0; i < facets_.triangles.size(); i += stride)
    if (const double d = norm(facets_.points[facets_.triangles[i][0]] - p); d < nearest) {
      nearest = d;
      best = {static_cast<std::uint32_t>(i), {1, 0, 0}};
    }
  box point;
  point.add(p);
  box within = point.grown(nearest);
  (void)tree_->any_meeting(within, [&](std::size_t i) {
    const auto& t = facets_.triangles[i];
    const auto& c = facets_.points;
    const auto share = nearest_on_triangle(p, c[t[0]], c[t[1]], c[t[2]]);
    const vec3 there = share[0] * c[t[0]] + share[1] * c[t[1]] + share[2] * c[t[2]];
    if (const double d = norm(p - there); d < nearest) {
      nearest = d;
      within = point.grown(nearest);
      best = {static_cast<std::uint32_t>(i), share};
    }
    return false;
  });
  return best;
}

/// The edge's second point of control: straight on where its first corner has no direction.
vec3 fitted_form::handle(std::uint32_t from, std::uint32_t to) const {
  const vec3 chord = facets_.points[to] - facets_.points[from];
  if (!directions_.at(from))
    return facets_.points[from] + chord / 3;
  const vec3 n = *directions_.at(from);
  const vec3 along = chord - dot(chord, n) * n;
  const double length = norm(chord);
  const double cosine = norm(along) / length;
  return facets_.points[from] + 2 * length / (3 * (1 + cosine)) * normalized(along);
}

fitted_form::patch fitted_form::patch_on(const triangle_corners& t) const {
  patch result;
  vec3 edges;
  vec3 middle;
  for (int i = 0; i < 3; ++i) {
    result.corner[i] = facets_.points[t[i]];
    middle += result.corner[i] / 3;
    for (int j = 0; j < 2; ++j) {
      result.edge[i][j] = handle(t[i], t[(i + 1 + j) % 3]);
      edges += result.edge[i][j] / 6;
    }
  }
  result.middle = edges + 0.5 * (edges - middle);
  return result;
}

fitted_form::patch::slopes fitted_form::patch::operator()(const std::array<double, 3>& s) const {
  slopes result;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    result.by[i] = 3 * s[i] * (s[i] * corner[i] + 2 * s[j] * edge[i][0] + 2 * s[k] * edge[i][1]) +
                   3 * s[j] * s[j] * edge[j][1] + 3 * s[k] * s[k] * edge[k][0] +
                   6 * s[j] * s[k] * middle;
    result.at += s[i] / 3 * result.by[i];  // Of a form of third order.
  }
  return result;
}

/// Unit; between the corners as a facet has it.
vec3 fitted_form::normal_at(const patch_point& where) const {
  const auto& t = facets_.triangles[where.triangle];
  vec3 normal;
  for (int i = 0; i < 3; ++i)
    normal += where.share[i] * directions_.at(t[i]).value_or(directions_.mean_at(t[i]));
  return normalized(normal);
}

/// The shares by a step of Newton's method, beyond the triangle where it leads there.
std::array<double, 3> fitted_form::stepped(const patch_point& from, const patch::slopes& here,
                                           vec3 aside) {
  const vec3 u = here.by[1] - here.by[0];
  const vec3 v = here.by[2] - here.by[0];
  const double uu = dot(u, u);
  const double uv = dot(u, v);
  const double vv = dot(v, v);
  const double det = uu * vv - uv * uv;
  if (!(det > 0))
    return from.share;
  const double by_u = (vv * dot(aside, u) - uv * dot(aside, v)) / det;
  const double by_v = (uu * dot(aside, v) - uv * dot(aside, u)) / det;
  return {from.share[0] - by_u - by_v, from.share[1] + by_u, from.share[2] + by_v};
}

surface_foot fitted_form::operator()(vec3 p) const {
  auto where = nearest_facet(p);
  surface_foot foot;
  for (int step = 0; step < most_foot_steps; ++step) {
    const auto on = patch_on(facets_.triangles[where.triangle]);
    const auto here = on(where.share);
    foot = {here.at, normal_at(where)};
    const vec3 off = p - foot.at;
    const vec3 aside = off - dot(off, foot.normal) * foot.normal;
    if (norm(aside) <= std::max(foot_step * norm(on.corner[1] - on.corner[0]), ulp * norm(p)))
      break;
    where.share = stepped(where, here, aside);
    if (std::ranges::any_of(where.share, [](double s) { return s < 0; }))
      where = nearest_facet(flat_at(where));
  }
  return foot;
}

vec3 fitted_form::flat_at(const patch_point& where) const {
  const auto& t = facets_.triangles[where.triangle];
  vec3 result;
  for (int i = 0; i < 3; ++i)
    result += where.share[i] * facets_.points[t[i]];
  return result;
}

std::optional<exact_wall> fit_free_form(const facet_corners& facets,
                                        const std::optional<box>& near) {
  exact_wall wall;
  wall.free_form = near ? fitted_form::near(facets, *near) : fitted_form::through(facets);
  return wall.free_form ? std::optional(wall) : std::nullopt;
}

}  // namespace tedit
