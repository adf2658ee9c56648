// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/circle_fit.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::desktop {

/// Kasa's fit: linear, and exact for points that are on a circle.
std::optional<plane_circle> fit_circle(std::span<const std::array<double, 2>> points) {
  if (points.size() < 3)
    return std::nullopt;
  double mx = 0;
  double my = 0;
  for (const auto& [x, y] : points) {
    mx += x / static_cast<double>(points.size());
    my += y / static_cast<double>(points.size());
  }
  double uu = 0;
  double uv = 0;
  double vv = 0;
  double ur = 0;
  double vr = 0;
  for (const auto& [x, y] : points) {
    const double u = x - mx;
    const double v = y - my;
    const double r2 = u * u + v * v;
    uu += u * u;
    uv += u * v;
    vv += v * v;
    ur += u * r2 / 2;
    vr += v * r2 / 2;
  }
  const double det = uu * vv - uv * uv;
  if (!(det > 1e-9 * (uu + vv) * (uu + vv)))
    return std::nullopt;
  plane_circle circle{{mx + (ur * vv - vr * uv) / det, my + (vr * uu - ur * uv) / det}};
  const auto distance = [&](const std::array<double, 2>& p) {
    return std::hypot(p[0] - circle.middle[0], p[1] - circle.middle[1]);
  };
  for (const auto& p : points)
    circle.radius += distance(p) / static_cast<double>(points.size());
  for (const auto& p : points)
    circle.worst = std::max(circle.worst, std::abs(distance(p) - circle.radius));
  return circle;
}

std::array<vec3, 2> across(const vec3& z) {
  const vec3 any = std::abs(z.z) < 0.9 ? vec3{0, 0, 1} : vec3{0, 1, 0};
  const vec3 x = normalized(cross(any, z));
  return {x, cross(z, x)};
}

}  // namespace tedit::desktop
