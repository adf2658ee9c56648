// SPDX-License-Identifier: AGPL-3.0-or-later
// Points and maps of the plane that outlines are drawn in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tedit::ops {

using point2 = std::array<double, 2>;

[[nodiscard]] inline double gap_of(point2 a, point2 b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Twice the area of a triangle; positive where it goes counter-clockwise.
[[nodiscard]] inline double turn_of(point2 a, point2 b, point2 c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The distance of the two nearest ends of an edge of a closed outline; m or whatever they are in.
[[nodiscard]] inline double shortest_edge(const std::vector<point2>& points) {
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i)
    least = std::min(least, gap_of(points[i], points[(i + 1) % points.size()]));
  return least;
}

/// Whether two edges without a common end meet.
[[nodiscard]] inline bool edges_meet(point2 a, point2 b, point2 c, point2 d) {
  const auto between = [](double x, double u, double v) {
    return x >= std::min(u, v) && x <= std::max(u, v);
  };
  const bool apart =
    std::max(a[0], b[0]) < std::min(c[0], d[0]) || std::max(c[0], d[0]) < std::min(a[0], b[0]) ||
    std::max(a[1], b[1]) < std::min(c[1], d[1]) || std::max(c[1], d[1]) < std::min(a[1], b[1]);
  return !apart && between(0, turn_of(a, b, c), turn_of(a, b, d)) &&
         between(0, turn_of(c, d, a), turn_of(c, d, b));
}

/// (x, y) goes to (a x + c y + e, b x + d y + f), as SVG has it.
struct affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  [[nodiscard]] point2 operator()(point2 p) const {
    return {a * p[0] + c * p[1] + e, b * p[0] + d * p[1] + f};
  }
  /// Of a way: without the shift.
  [[nodiscard]] point2 of_way(point2 p) const { return {a * p[0] + c * p[1], b * p[0] + d * p[1]}; }
  /// First `inner`, then this.
  [[nodiscard]] affine of(const affine& inner) const {
    const auto origin = (*this)({inner.e, inner.f});
    return {a * inner.a + c * inner.b,
            b * inner.a + d * inner.b,
            a * inner.c + c * inner.d,
            b * inner.c + d * inner.d,
            origin[0],
            origin[1]};
  }
};

}  // namespace tedit::ops
