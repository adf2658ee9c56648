// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/handle_lens.hpp"

#include <algorithm>
#include <cmath>

#include "client-qt/model/round_step.hpp"

namespace tedit::desktop {

double pixels_between(QPointF a, QPointF b) {
  return std::hypot(b.x() - a.x(), b.y() - a.y());
}

bool lens::shows(QPointF at) const {
  constexpr double margin = 8;
  return room.isEmpty() || (at.x() > margin && at.y() > margin && at.x() < room.width() - margin &&
                            at.y() < room.height() - margin);
}

double lens::metres_per_pixel(const vec3& at) const {
  const double pixels = pixels_between(to_screen(at), to_screen(at + step * right));
  return pixels > 0 ? step / pixels : step;
}

std::optional<double> along_axis(const std::array<vec3, 2>& ray, const vec3& at,
                                 const vec3& along) {
  constexpr double least_sine = 0.14;
  const vec3 way = normalized(ray[1] - ray[0]);
  const double cosine = dot(way, along);
  const double sine2 = 1 - cosine * cosine;
  if (!(sine2 > least_sine * least_sine))
    return std::nullopt;
  const vec3 to_ray = ray[0] - at;
  return (dot(to_ray, along) - cosine * dot(to_ray, way)) / sine2;
}

std::optional<vec3> on_plane(const std::array<vec3, 2>& ray, const vec3& at, const vec3& normal) {
  constexpr double least_sine = 0.1;
  const vec3 way = normalized(ray[1] - ray[0]);
  const double slope = dot(way, normal);
  if (!(std::abs(slope) > least_sine))
    return std::nullopt;
  return ray[0] + dot(at - ray[0], normal) / slope * way;
}

vec3 on_sphere(const std::array<vec3, 2>& ray, const vec3& middle, double radius, bool near) {
  const vec3 way = normalized(ray[1] - ray[0]);
  const double ahead = dot(middle - ray[0], way);
  const vec3 nearest = ray[0] + ahead * way;
  const vec3 beside = nearest - middle;
  const double rest = radius * radius - dot(beside, beside);
  if (rest <= 0)
    return middle + radius * normalized(beside);
  return nearest + (near ? -1 : 1) * std::sqrt(rest) * way;
}

double drag_step(double least) {
  return round_step(std::max(least, 1e-12));
}

}  // namespace tedit::desktop
