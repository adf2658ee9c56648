// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/mesher/ground.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::scan {

namespace {

constexpr double crease_cosine = 0.766;  ///< 40 degrees.

std::vector<box> boxes_of(const std::vector<std::array<vec3, 3>>& pieces) {
  std::vector<box> boxes;
  for (const auto& piece : pieces)
    boxes.push_back(box_of(piece));
  return boxes;
}

vec3 nearest_on_segment(vec3 p, vec3 a, vec3 b) {
  const vec3 along = b - a;
  const double whole = dot(along, along);
  return whole > 0 ? a + std::clamp(dot(p - a, along) / whole, 0.0, 1.0) * along : a;
}

}  // namespace

vec3 nearest_on_triangle(vec3 p, vec3 a, vec3 b, vec3 c) {
  const vec3 n = cross(b - a, c - a);
  const auto inner = [&](vec3 from, vec3 to) { return dot(cross(to - from, p - from), n) >= 0; };
  if (dot(n, n) > 0 && inner(a, b) && inner(b, c) && inner(c, a)) {
    const vec3 unit = normalized(n);
    return p - dot(p - a, unit) * unit;
  }
  vec3 best = nearest_on_segment(p, a, b);
  for (const vec3 other : {nearest_on_segment(p, b, c), nearest_on_segment(p, c, a)})
    if (norm(other - p) < norm(best - p))
      best = other;
  return best;
}

piece_set::piece_set(std::vector<std::array<vec3, 3>> pieces)
    : pieces_(std::move(pieces)), tree_(boxes_of(pieces_)) {}

std::pair<vec3, std::size_t> piece_set::nearest(vec3 p, double guess) const {
  box point;
  point.add(p);
  std::pair<vec3, std::size_t> best{p, pieces_.size()};
  const auto extent = tree_.extent();
  const double least_guess = 1e-6 * norm(extent.high - extent.low) + 1e-12;
  if (!is_finite(p))
    return {pieces_.front()[0], 0};
  for (double reach = std::max(guess, least_guess); best.second == pieces_.size(); reach *= 4) {
    double least = reach;
    box within = point.grown(least);  // Shrinks as nearer ones are found.
    (void)tree_.any_meeting(within, [&](std::size_t i) {
      const auto& [a, b, c] = pieces_[i];
      const vec3 found = nearest_on_triangle(p, a, b, c);
      if (const double d = norm(found - p); d < least) {
        least = d;
        best = {found, i};
        within = point.grown(least);
      }
      return false;
    });
  }
  return best;
}

ground::ground(const surface_part& part)
    : part_(part),
      across_(triangles_across(part.surface.triangles)),
      triangles_of_(part.shapes.size()) {
  std::vector<std::vector<std::array<vec3, 3>>> pieces(part.shapes.size());
  for (std::uint32_t t = 0; t < part.surface.triangles.size(); ++t) {
    const auto& v = part.surface.triangles[t];
    const auto& at = part.surface.points;
    pieces[part.patch_of[t]].push_back({at[v[0]], at[v[1]], at[v[2]]});
    triangles_of_[part.patch_of[t]].push_back(t);
  }
  for (auto& one : pieces)
    patches_.emplace_back(std::move(one));
  find_lines();
  find_radii();
}

void ground::find_lines() {
  std::map<edge_key, std::vector<std::array<vec3, 3>>> pieces;
  const auto& surface = part_.surface;
  const auto normal = [&](std::uint32_t t) {
    const auto& v = surface.triangles[t];
    const vec3 a = surface.points[v[0]];
    return normalized(cross(surface.points[v[1]] - a, surface.points[v[2]] - a));
  };
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto other = across_[t][k];
      if (other == no_id || other < t)
        continue;
      const auto a = surface.triangles[t][k];
      const auto b = surface.triangles[t][(k + 1) % 3];
      const auto mine = part_.patch_of[t];
      const auto theirs = part_.patch_of[other];
      const bool is_free = part_.shapes[mine].form == surface_form::free;
      if (mine == theirs && (!is_free || dot(normal(t), normal(other)) >= crease_cosine))
        continue;
      if (mine == theirs)
        creases_.push_back(key_of(a, b));
      pieces[key_of(mine, theirs)].push_back(
        {surface.points[a], surface.points[b], surface.points[b]});
    }
  for (auto& [key, list] : pieces)
    lines_.emplace(key, piece_set(std::move(list)));
}

/// By the angle to each neighbour over the way between both.
void ground::find_radii() {
  const auto& surface = part_.surface;
  radii_.assign(surface.triangles.size(), HUGE_VAL);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    if (part_.shapes[part_.patch_of[t]].form != surface_form::free)
      continue;
    for (int k = 0; k < 3; ++k) {
      const auto other = across_[t][k];
      if (other == no_id || part_.patch_of[other] != part_.patch_of[t])
        continue;
      const vec3 a = surface.points[surface.triangles[t][k]];
      const vec3 b = surface.points[surface.triangles[t][(k + 1) % 3]];
      const auto half = [&](std::uint32_t one) {
        const auto& v = surface.triangles[one];
        return cross(surface.points[v[1]] - surface.points[v[0]],
                     surface.points[v[2]] - surface.points[v[0]]);
      };
      const double cosine = dot(normalized(half(t)), normalized(half(other)));
      const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
      // A third of both heights over the common edge, in terms of a strip half of them.
      const double way = (norm(half(t)) + norm(half(other))) / (2 * norm(b - a));
      if (angle > 1e-3 && cosine >= crease_cosine)
        radii_[t] = std::min(radii_[t], way / angle);
    }
  }
}

vec3 ground::on_patch(vec3 p, std::uint32_t patch, double guess) const {
  const auto& shape = part_.shapes[patch];
  return shape.form == surface_form::free ? patches_[patch].nearest(p, guess).first
                                          : shape.project(p);
}

vec3 ground::on_line(vec3 p, std::uint32_t a, std::uint32_t b, double guess) const {
  constexpr int most_steps = 30;
  const auto line = lines_.find(key_of(a, b));
  if (line == lines_.end())
    return p;
  const vec3 start = line->second.nearest(p, guess).first;
  vec3 at = start;
  const auto& first = part_.shapes[a];
  const auto& second = part_.shapes[b];
  for (int step = 0; step < most_steps; ++step)
    at = second.project(first.project(at));
  return is_finite(at) && norm(at - start) <= 0.5 * guess ? at : start;
}

double ground::radius_at(vec3 p, std::uint32_t patch, double guess) const {
  const auto& shape = part_.shapes[patch];
  switch (shape.form) {
    case surface_form::plane:
      return HUGE_VAL;
    case surface_form::cylinder:
    case surface_form::sphere:
      return shape.wall.radius;
    case surface_form::cone:
      return std::abs(shape.wall.radius +
                      shape.wall.slope * dot(p - shape.wall.point, shape.wall.axis));
    case surface_form::free:
      break;
  }
  const auto found = patches_[patch].nearest(p, guess).second;
  return radii_[triangles_of_[patch][found]];
}

}  // namespace tedit::scan
