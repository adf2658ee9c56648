// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/distances.hpp"

#include <algorithm>
#include <cmath>

namespace tedit {

/// Source: the closest points of two lines, each then held to its segment.
double segments_apart(vec3 a, vec3 b, vec3 c, vec3 d) {
  const vec3 u = b - a;
  const vec3 w = d - c;
  const vec3 r = a - c;
  const double uu = dot(u, u);
  const double ww = dot(w, w);
  const double uw = dot(u, w);
  const double ur = dot(u, r);
  const double wr = dot(w, r);
  const double det = uu * ww - uw * uw;
  double s = det > 1e-12 * uu * ww ? std::clamp((uw * wr - ur * ww) / det, 0.0, 1.0) : 0;
  const double t = ww > 0 ? std::clamp((uw * s + wr) / ww, 0.0, 1.0) : 0;
  s = uu > 0 ? std::clamp((uw * t - ur) / uu, 0.0, 1.0) : 0;
  return norm(r + s * u - t * w);
}

double point_to_triangle(vec3 p, vec3 a, vec3 b, vec3 c) {
  const vec3 n = cross(b - a, c - a);
  const auto inner = [&](vec3 from, vec3 to) { return dot(cross(to - from, p - from), n) >= 0; };
  if (dot(n, n) > 0 && inner(a, b) && inner(b, c) && inner(c, a))
    return std::abs(dot(p - a, normalized(n)));
  return std::min(
    {segments_apart(p, p, a, b), segments_apart(p, p, b, c), segments_apart(p, p, c, a)});
}

std::array<double, 3> nearest_on_triangle(vec3 p, vec3 a, vec3 b, vec3 c) {
  const vec3 ab = b - a;
  const vec3 ac = c - a;
  const double b_of_a = dot(ab, p - a);
  const double c_of_a = dot(ac, p - a);
  const double b_of_b = dot(ab, p - b);
  const double c_of_b = dot(ac, p - b);
  const double b_of_c = dot(ab, p - c);
  const double c_of_c = dot(ac, p - c);
  if (b_of_a <= 0 && c_of_a <= 0)
    return {1, 0, 0};
  if (b_of_b >= 0 && c_of_b <= b_of_b)
    return {0, 1, 0};
  if (c_of_c >= 0 && b_of_c <= c_of_c)
    return {0, 0, 1};
  const double at_c = b_of_a * c_of_b - b_of_b * c_of_a;
  if (at_c <= 0 && b_of_a >= 0 && b_of_b <= 0) {
    const double t = b_of_a / (b_of_a - b_of_b);
    return {1 - t, t, 0};
  }
  const double at_b = b_of_c * c_of_a - b_of_a * c_of_c;
  if (at_b <= 0 && c_of_a >= 0 && c_of_c <= 0) {
    const double t = c_of_a / (c_of_a - c_of_c);
    return {1 - t, 0, t};
  }
  const double at_a = b_of_b * c_of_c - b_of_c * c_of_b;
  const double to_c = c_of_b - b_of_b;
  const double to_b = b_of_c - c_of_c;
  if (at_a <= 0 && to_c >= 0 && to_b >= 0) {
    const double t = to_c / (to_c + to_b);
    return {0, 1 - t, t};
  }
  const double sum = at_a + at_b + at_c;
  return {at_a / sum, at_b / sum, at_c / sum};
}

std::optional<triangle_hit> ray_through(const std::array<vec3, 3>& triangle, vec3 origin,
                                        vec3 direction) {
  const vec3 one = triangle[1] - triangle[0];
  const vec3 two = triangle[2] - triangle[0];
  const vec3 across = cross(direction, two);
  const double det = dot(one, across);
  if (det == 0)
    return std::nullopt;
  const vec3 from = origin - triangle[0];
  const double u = dot(from, across) / det;
  const vec3 q = cross(from, one);
  const double v = dot(direction, q) / det;
  const double distance = dot(two, q) / det;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && distance >= 0))
    return std::nullopt;
  return triangle_hit{distance, dot(cross(one, two), direction) > 0};
}

}  // namespace tedit
