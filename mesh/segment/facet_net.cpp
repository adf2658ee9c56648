// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/segment/facet_net.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace tedit {

namespace {

/// A tenth of a degree: less than any tessellation bends.
constexpr double flat_sine = 1.7e-3;
/// Triangles that are lower, in terms of the tolerance, have no normal worth the name.
constexpr double sliver_heights = 4;

vec3 area_of(const triangle_surface& surface, std::uint32_t t) {
  const auto& v = surface.triangles[t];
  const vec3 a = surface.points[v[0]];
  return 0.5 * cross(surface.points[v[1]] - a, surface.points[v[2]] - a);
}

double edge_length(const triangle_surface& surface, std::uint32_t t, int k) {
  const auto& v = surface.triangles[t];
  return norm(surface.points[v[(k + 1) % 3]] - surface.points[v[k]]);
}

int longest_edge(const triangle_surface& surface, std::uint32_t t) {
  int best = 0;
  for (int k = 1; k < 3; ++k)
    if (edge_length(surface, t, k) > edge_length(surface, t, best))
      best = k;
  return best;
}

}  // namespace

std::vector<triangle_corners> triangles_across(const std::vector<triangle_corners>& triangles) {
  struct side {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
    std::uint32_t edge;
  };
  std::vector<side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      sides.push_back({low, high, t, k});
    }
  std::ranges::sort(sides, [](const side& a, const side& b) {
    return std::tie(a.low, a.high, a.triangle, a.edge) <
           std::tie(b.low, b.high, b.triangle, b.edge);
  });
  std::vector<triangle_corners> across(triangles.size(), {no_id, no_id, no_id});
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
      ++end;
    if (end - i == 2) {
      across[sides[i].triangle][sides[i].edge] = sides[i + 1].triangle;
      across[sides[i + 1].triangle][sides[i + 1].edge] = sides[i].triangle;
    }
    i = end;
  }
  return across;
}

facet_net::facet_net(const triangle_surface& surface, double tolerance,
                     const std::vector<std::uint32_t>& groups)
    : surface_(surface),
      tolerance_(tolerance),
      groups_(groups),
      across_(triangles_across(surface.triangles)),
      facet_of_(surface.triangles.size(), no_id) {
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const double longest = edge_length(surface, t, longest_edge(surface, t));
    heights_.push_back(longest > 0 ? 2 * norm(area_of(surface, t)) / longest : 0);
  }
  // The fattest have the truest normals.
  std::vector<std::uint32_t> order(heights_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](auto a, auto b) { return heights_[a] > heights_[b]; });
  for (const auto t : order)
    if (facet_of_[t] == no_id && heights_[t] > sliver_heights * tolerance_)
      grow(t);
  attach_slivers();
  add_corners();
  add_links();
}

vec3 facet_net::normal_of(std::uint32_t triangle) const {
  return normalized(area_of(surface_, triangle));
}

bool facet_net::same_group(std::uint32_t a, std::uint32_t b) const {
  return groups_.empty() || groups_[a] == groups_[b];
}

/// All that lies in the plane of the triangles so far: their sum is a truer plane than the first.
void facet_net::grow(std::uint32_t seed) {
  const auto id = static_cast<std::uint32_t>(facets_.size());
  auto& facet = facets_.emplace_back();
  vec3 moment;
  double whole = 0;
  const auto take = [&](std::uint32_t t) {
    const auto& v = surface_.triangles[t];
    const vec3 area = area_of(surface_, t);
    facet_of_[t] = id;
    facet.triangles.push_back(t);
    facet.area += area;
    whole += norm(area);
    moment +=
      norm(area) / 3 * (surface_.points[v[0]] + surface_.points[v[1]] + surface_.points[v[2]]);
  };
  const auto fits = [&](std::uint32_t t) {
    const vec3 n = normalized(facet.area);
    const vec3 at = moment / whole;
    const auto& v = surface_.triangles[t];
    if (!std::ranges::all_of(
          v, [&](auto p) { return std::abs(dot(surface_.points[p] - at, n)) <= tolerance_; }))
      return false;
    const double noise = 2 * tolerance_ / heights_[t];
    return heights_[t] <= sliver_heights * tolerance_ ||
           (dot(n, normal_of(t)) > 0 && norm(cross(n, normal_of(t))) <= flat_sine + noise);
  };
  take(seed);
  for (std::size_t i = 0; i < facet.triangles.size(); ++i)
    for (const auto next : across_[facet.triangles[i]])
      if (next != no_id && facet_of_[next] == no_id && same_group(seed, next) && fits(next))
        take(next);
  facet.middle = moment / whole;
}

/// Those in a row go one after the other.
void facet_net::attach_slivers() {
  std::vector<std::uint32_t> left;
  for (std::uint32_t t = 0; t < facet_of_.size(); ++t)
    if (facet_of_[t] == no_id)
      left.push_back(t);
  for (std::size_t before = left.size() + 1; !left.empty() && left.size() < before;) {
    before = left.size();
    std::erase_if(left, [&](std::uint32_t t) {
      const auto behind = across_[t][longest_edge(surface_, t)];
      if (behind == no_id || facet_of_[behind] == no_id || !same_group(t, behind))
        return false;
      facet_of_[t] = facet_of_[behind];
      facets_[facet_of_[t]].triangles.push_back(t);
      return true;
    });
  }
  for (const auto t : left) {
    facet_of_[t] = static_cast<std::uint32_t>(facets_.size());
    facets_.push_back(
      {area_of(surface_, t), surface_.points[surface_.triangles[t][0]], {t}, {}, {}});
  }
}

void facet_net::add_corners() {
  for (auto& facet : facets_) {
    for (const auto t : facet.triangles)
      facet.corners.insert(facet.corners.end(), surface_.triangles[t].begin(),
                           surface_.triangles[t].end());
    std::ranges::sort(facet.corners);
    facet.corners.erase(std::ranges::unique(facet.corners).begin(), facet.corners.end());
  }
}

void facet_net::add_links() {
  for (std::uint32_t f = 0; f < facets_.size(); ++f) {
    std::map<std::uint32_t, double> lengths;
    for (const auto t : facets_[f].triangles)
      for (int k = 0; k < 3; ++k)
        if (const auto behind = across_[t][k]; behind != no_id && facet_of_[behind] != f)
          lengths[facet_of_[behind]] += edge_length(surface_, t, k);
    const vec3 n = normalized(facets_[f].area);
    for (const auto& [other, length] : lengths)
      facets_[f].links.push_back({other, length, dot(n, normalized(facets_[other].area))});
  }
}

}  // namespace tedit
