// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/wall_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace tedit::ops {

namespace {

constexpr double turn = 2 * std::numbers::pi;
/// A gap that is narrower (rad) is none: the piece goes all around.
constexpr double least_gap = 1e-3;

/// The angle in [0, 2 pi).
double wrapped(double angle) {
  const double result = std::fmod(angle, turn);
  return result < 0 ? result + turn : result;
}

struct gap {
  double width = 0;
  double middle = 0;
};

/// The widest one between the arcs that triangles cover, by the angles of their corners.
gap widest_gap(const std::vector<std::array<double, 3>>& triangles) {
  std::vector<std::pair<double, double>> arcs;
  for (auto a : triangles) {
    for (auto& angle : a)
      angle = wrapped(angle);
    // A facet is less than half a turn wide: its arc is the one that leaves out the widest gap.
    std::ranges::sort(a);
    const double gaps[3] = {a[1] - a[0], a[2] - a[1], a[0] + turn - a[2]};
    const auto widest = std::max_element(gaps, gaps + 3) - gaps;
    const double first = a[(widest + 1) % 3];
    arcs.emplace_back(first, first + turn - gaps[widest]);
  }
  std::ranges::sort(arcs);
  double reached = arcs.front().first;
  gap best;
  for (const auto& [from, to] : arcs) {
    if (from - reached > best.width)
      best = {from - reached, 0.5 * (from + reached)};
    reached = std::max(reached, to);
  }
  if (const double last = arcs.front().first + turn - reached; last > best.width)
    best = {last, reached + 0.5 * last};
  return best;
}

}  // namespace

wall_map::wall_map(const mesh_version& mesh, const exact_wall& wall,
                   std::span<const facet_id> facets)
    : wall_(wall), axis_(wall.shape.axis) {
  double corners = 0;
  for (const auto f : facets)
    for (const auto v : mesh.facet(f).v) {
      origin_ += mesh.position(v);
      ++corners;
    }
  origin_ = origin_ / corners;
  const auto& shape = wall.shape;
  if (wall.sphere_radius > 0) {
    axis_ = normalized(origin_ - shape.point);
    origin_ = shape.point;
  }
  const vec3 helper = std::abs(axis_.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  u_ = normalized(cross(helper, axis_));
  w_ = cross(axis_, u_);
  if (wall.flat() || wall.sphere_radius > 0)
    return;
  radius_ = shape.radius;
  origin_ =
    shape.point + (wall.tube_radius > 0 ? vec3{} : dot(origin_ - shape.point, axis_) * axis_);
  if (shape.type == wall_shape::kind::cone)
    radius_ = shape.radius + shape.slope * dot(origin_ - shape.point, axis_);
  find_cuts(mesh, facets);
}

void wall_map::find_cuts(const mesh_version& mesh, std::span<const facet_id> facets) {
  const auto gap_of = [&](const auto& angle) {
    std::vector<std::array<double, 3>> around;
    for (const auto f : facets) {
      const auto& v = mesh.facet(f).v;
      around.push_back(
        {angle(mesh.position(v[0])), angle(mesh.position(v[1])), angle(mesh.position(v[2]))});
    }
    return widest_gap(around);
  };
  const auto cut = gap_of([&](vec3 p) { return about_axis(p); });
  start_ = cut.middle;
  ring_ = cut.width < least_gap;
  if (wall_.tube_radius <= 0)
    return;
  const auto tube_cut = gap_of([&](vec3 p) { return about_tube(p); });
  tube_start_ = tube_cut.middle;
  tube_is_ring_ = tube_cut.width < least_gap;
  if (tube_is_ring_) {
    ring_ = true;
    radius_ = wall_.tube_radius;
  }
}

vec3 wall_map::radial(double angle) const {
  return std::cos(angle) * u_ + std::sin(angle) * w_;
}

double wall_map::about_axis(vec3 p) const {
  return std::atan2(dot(p - origin_, w_), dot(p - origin_, u_));
}

double wall_map::about_tube(vec3 p) const {
  const vec3 d = p - origin_;
  const double height = dot(d, axis_);
  return std::atan2(height, norm(d - height * axis_) - wall_.shape.radius);
}

wall_map::turned wall_map::place_of(vec3 p) const {
  const double angle = about_axis(p);
  if (tube_is_ring_)
    return {about_tube(p), -wall_.shape.radius * wrapped(angle - start_)};
  if (wall_.tube_radius > 0)
    return {angle, wall_.tube_radius * wrapped(about_tube(p) - tube_start_)};
  const double height = dot(p - origin_, axis_);
  return {angle, height * std::hypot(1, wall_.shape.slope)};
}

vec3 wall_map::point_at(turned at) const {
  if (wall_.tube_radius > 0) {
    const double angle = tube_is_ring_ ? start_ - at.length / wall_.shape.radius : at.angle;
    const double tube = tube_is_ring_ ? at.angle : tube_start_ + at.length / wall_.tube_radius;
    return origin_ + wall_.tube_radius * std::sin(tube) * axis_ +
           (wall_.shape.radius + wall_.tube_radius * std::cos(tube)) * radial(angle);
  }
  const double height = at.length / std::hypot(1, wall_.shape.slope);
  return origin_ + height * axis_ + (radius_ + wall_.shape.slope * height) * radial(at.angle);
}

std::array<double, 2> wall_map::flatten(vec3 p) const {
  const vec3 d = p - origin_;
  const double side = wall_.shape.side;
  if (wall_.flat())
    return {dot(d, u_), dot(d, w_)};
  if (wall_.sphere_radius > 0) {
    const vec3 n = normalized(d);
    const double scale = 2 * wall_.sphere_radius / (1 + dot(n, axis_));
    return {scale * dot(n, u_), side * scale * dot(n, w_)};
  }
  const auto [angle, length] = place_of(p);
  if (!ring_)
    return {radius_ * wrapped(angle - start_), side * length};
  // Seen from inside a hole the lengths grow inwards, so that the ring keeps its orientation.
  const double rho = radius_ * std::exp(-side * length / radius_);
  return {rho * std::cos(angle), rho * std::sin(angle)};
}

vec3 wall_map::lift(std::array<double, 2> p) const {
  const double side = wall_.shape.side;
  if (wall_.flat())
    return origin_ + p[0] * u_ + p[1] * w_;
  if (wall_.sphere_radius > 0) {
    const double x = p[0] / (2 * wall_.sphere_radius);
    const double y = side * p[1] / (2 * wall_.sphere_radius);
    const double square = x * x + y * y;
    return origin_ +
           (wall_.sphere_radius / (1 + square)) * (2 * x * u_ + 2 * y * w_ + (1 - square) * axis_);
  }
  if (!ring_)
    return point_at({p[0] / radius_ + start_, side * p[1]});
  return point_at(
    {std::atan2(p[1], p[0]), -side * radius_ * std::log(std::hypot(p[0], p[1]) / radius_)});
}

}  // namespace tedit::ops
