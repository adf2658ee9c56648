// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/mesher/working_surface.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::scan {

namespace {

/// A line that bends by more has a corner there (50 degrees); less is the tessellation of a curve.
constexpr double straight_cosine = 0.643;

bool has(const triangle_corners& c, std::uint32_t v) {
  return c[0] == v || c[1] == v || c[2] == v;
}

}  // namespace

working_surface::working_surface(const ground& base)
    : points_(base.part().surface.points),
      triangles_(base.part().surface.triangles),
      patches_(base.part().patch_of),
      live_(triangles_.size(), true),
      of_(points_.size()),
      creases_(base.creases().begin(), base.creases().end()) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    link(t);
}

void working_surface::link(std::uint32_t t) {
  for (const auto v : triangles_[t])
    of_[v].push_back(t);
}

void working_surface::unlink(std::uint32_t t) {
  for (const auto v : triangles_[t])
    std::erase(of_[v], t);
  live_[t] = false;
}

void working_surface::add(const triangle_corners& c, std::uint32_t patch) {
  triangles_.push_back(c);
  patches_.push_back(patch);
  live_.push_back(true);
  link(static_cast<std::uint32_t>(triangles_.size() - 1));
}

std::vector<std::uint32_t> working_surface::beside(vertex a, vertex b) const {
  std::vector<std::uint32_t> found;
  for (const auto t : of_[a])
    if (has(triangles_[t], b))
      found.push_back(t);
  return found;
}

std::vector<working_surface::vertex> working_surface::neighbours(vertex v) const {
  std::vector<vertex> found;
  for (const auto t : of_[v])
    for (const auto w : triangles_[t])
      if (w != v)
        found.push_back(w);
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  return found;
}

bool working_surface::is_line(vertex a, vertex b) const {
  const auto two = beside(a, b);
  return two.size() != 2 || patches_[two[0]] != patches_[two[1]] ||
         (!creases_.empty() && creases_.contains(key_of(a, b)));
}

std::vector<working_surface::vertex> working_surface::line_neighbours(vertex v) const {
  std::vector<vertex> found;
  const auto& mine = of_[v];
  const bool one_patch = std::ranges::all_of(
    mine, [&](std::uint32_t t) { return patches_[t] == patches_[mine.front()]; });
  if (one_patch && creases_.empty())
    return found;
  for (const auto w : neighbours(v))
    if (is_line(v, w))
      found.push_back(w);
  return found;
}

bool working_surface::is_corner(vertex v) const {
  const auto ends = line_neighbours(v);
  if (ends.empty())
    return false;
  if (ends.size() != 2)
    return true;
  const vec3 in = normalized(points_[v] - points_[ends[0]]);
  const vec3 out = normalized(points_[ends[1]] - points_[v]);
  return dot(in, out) < straight_cosine;
}

working_surface::vertex working_surface::opposite(std::uint32_t t, vertex a, vertex b) const {
  const auto& c = triangles_[t];
  return c[0] != a && c[0] != b ? c[0] : c[1] != a && c[1] != b ? c[1] : c[2];
}

vec3 working_surface::normal_of(const triangle_corners& c) const {
  return cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]);
}

double working_surface::quality_of(const triangle_corners& c) const {
  const double la = norm(points_[c[1]] - points_[c[2]]);
  const double lb = norm(points_[c[2]] - points_[c[0]]);
  const double lc = norm(points_[c[0]] - points_[c[1]]);
  const vec3 n = normal_of(c);
  const double product = la * lb * lc;
  return product > 0 ? 4 * dot(n, n) / (product * (la + lb + lc)) : 0;
}

working_surface::vertex working_surface::split(vertex a, vertex b, vec3 at) {
  const auto middle = static_cast<vertex>(points_.size());
  points_.push_back(at);
  of_.emplace_back();
  if (creases_.erase(key_of(a, b)) > 0) {
    creases_.insert(key_of(a, middle));
    creases_.insert(key_of(middle, b));
  }
  for (const auto t : beside(a, b)) {
    auto first = triangles_[t];
    auto second = first;
    std::ranges::replace(first, b, middle);
    std::ranges::replace(second, a, middle);
    const auto patch = patches_[t];
    unlink(t);
    add(first, patch);
    add(second, patch);
  }
  return middle;
}

bool working_surface::may_merge(vertex gone, vertex kept) const {
  const auto two = beside(gone, kept);
  if (two.size() != 2)
    return false;
  // The link condition: the only neighbours of both are those across.
  const auto mine = neighbours(gone);
  const auto theirs = neighbours(kept);
  std::vector<vertex> common;
  std::ranges::set_intersection(mine, theirs, std::back_inserter(common));
  if (common.size() != 2 || mine.size() + theirs.size() < 8)
    return false;
  const auto lines = line_neighbours(gone);
  if (lines.empty())
    return true;
  if (is_corner(gone) || !is_line(gone, kept))
    return false;
  // The third side of a triangle must not become a second line along the first.
  const auto other = lines[0] == kept ? lines[1] : lines[0];
  return !std::ranges::binary_search(theirs, other) ||
         std::ranges::none_of(common, [&](vertex v) { return v == other; });
}

void working_surface::merge(vertex gone, vertex kept) {
  if (!creases_.empty())
    for (const auto w : neighbours(gone))
      if (creases_.erase(key_of(gone, w)) > 0 && w != kept)
        creases_.insert(key_of(kept, w));
  for (const auto t : std::vector(of_[gone])) {
    if (has(triangles_[t], kept)) {
      unlink(t);
      continue;
    }
    std::ranges::replace(triangles_[t], gone, kept);
    of_[kept].push_back(t);
  }
  of_[gone].clear();
}

bool working_surface::can_flip(vertex a, vertex b) const {
  const auto two = beside(a, b);
  if (two.size() != 2 || is_line(a, b))
    return false;
  const auto c = opposite(two[0], a, b);
  const auto d = opposite(two[1], a, b);
  return c != d && beside(c, d).empty() && of_[a].size() > 3 && of_[b].size() > 3;
}

void working_surface::flip(vertex a, vertex b) {
  const auto two = beside(a, b);
  const auto c = opposite(two[0], a, b);
  const auto d = opposite(two[1], a, b);
  auto first = triangles_[two[0]];   // a b c in some turn.
  auto second = triangles_[two[1]];  // b a d.
  std::ranges::replace(first, b, d);
  std::ranges::replace(second, a, c);
  const auto patch = patches_[two[0]];
  unlink(two[0]);
  unlink(two[1]);
  add(first, patch);
  add(second, patch);
}

}  // namespace tedit::scan
