// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/wall_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tedit::ops {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// The angle in [0, 2 pi).
double wrapped(double angle) {
  const double result = std::fmod(angle, turn);
  return result < 0 ? result + turn : result;
}

}  // namespace

wall_map::wall_map(const mesh_version& mesh, const wall_shape& shape,
                   std::span<const facet_id> facets)
    : shape_(shape) {
  const vec3 helper = std::abs(shape.axis.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  u_ = normalized(cross(helper, shape.axis));
  w_ = cross(shape.axis, u_);
  double corners = 0;
  for (const auto f : facets)
    for (const auto v : mesh.facet(f).v) {
      origin_ += mesh.position(v);
      ++corners;
    }
  origin_ = origin_ / corners;
  if (shape.type == wall_shape::kind::plane)
    return;
  origin_ = shape.point + dot(origin_ - shape.point, shape.axis) * shape.axis;
  // Arcs that facets cover; the widest gap between them is where the cylinder is cut.
  std::vector<std::pair<double, double>> arcs;
  for (const auto f : facets) {
    std::array<double, 3> a;
    for (int i = 0; i < 3; ++i)
      a[i] = wrapped(angle(mesh.position(mesh.facet(f).v[i])));
    // A facet is less than half a turn wide: its arc is the one that leaves out the widest gap.
    std::ranges::sort(a);
    const double gaps[3] = {a[1] - a[0], a[2] - a[1], a[0] + turn - a[2]};
    const auto widest = std::max_element(gaps, gaps + 3) - gaps;
    const double first = a[(widest + 1) % 3];
    arcs.emplace_back(first, first + turn - gaps[widest]);
  }
  std::ranges::sort(arcs);
  double reached = arcs.front().first;
  double gap = 0;
  for (const auto& [from, to] : arcs) {
    if (from - reached > gap)
      std::tie(gap, start_) = std::tuple(from - reached, 0.5 * (from + reached));
    reached = std::max(reached, to);
  }
  if (const double last = arcs.front().first + turn - reached; last > gap)
    std::tie(gap, start_) = std::tuple(last, reached + 0.5 * last);
  ring_ = gap < 1e-3;
}

double wall_map::angle(vec3 p) const {
  return std::atan2(dot(p - origin_, w_), dot(p - origin_, u_));
}

std::array<double, 2> wall_map::flatten(vec3 p) const {
  const vec3 d = p - origin_;
  if (shape_.type == wall_shape::kind::plane)
    return {dot(d, u_), dot(d, w_)};
  const double height = dot(d, shape_.axis);
  if (!ring_)
    return {shape_.radius * wrapped(angle(p) - start_), shape_.side * height};
  // Seen from inside a hole the heights grow inwards, so that the ring keeps its orientation.
  const double rho = shape_.radius * std::exp(-shape_.side * height / shape_.radius);
  return {rho * std::cos(angle(p)), rho * std::sin(angle(p))};
}

vec3 wall_map::lift(std::array<double, 2> p) const {
  if (shape_.type == wall_shape::kind::plane)
    return origin_ + p[0] * u_ + p[1] * w_;
  double height = shape_.side * p[1];
  double turned = p[0] / shape_.radius + start_;
  if (ring_) {
    height = -shape_.side * shape_.radius * std::log(std::hypot(p[0], p[1]) / shape_.radius);
    turned = std::atan2(p[1], p[0]);
  }
  return origin_ + height * shape_.axis +
         shape_.radius * (std::cos(turned) * u_ + std::sin(turned) * w_);
}

}  // namespace tedit::ops
