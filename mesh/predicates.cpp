// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

namespace tedit {

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

kernel::Point_3 point(vec3 p) {
  return {p.x, p.y, p.z};
}

}  // namespace

int orient3d(vec3 a, vec3 b, vec3 c, vec3 d) {
  // Far from zero the plain determinant has the right sign: its error is below 1e-14 times the sum
  // of the absolute products (Shewchuk 1997 gives 7.8e-16).
  const vec3 u = b - a;
  const vec3 v = c - a;
  const vec3 w = d - a;
  const double det = dot(u, cross(v, w));
  const auto mag = [](vec3 x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); };
  // The differences themselves are rounded: bound by the coordinates' size as well.
  const double size = std::max({mag(a), mag(b), mag(c), mag(d)});
  const double bound = 1e-14 * (mag(u) * mag(v) * mag(w)) +
                       4e-16 * size * (mag(u) * mag(v) + mag(v) * mag(w) + mag(w) * mag(u));
  if (det > bound)
    return 1;
  if (det < -bound)
    return -1;
  // CGAL's exact numbers know no nan.
  if (!is_finite(a) || !is_finite(b) || !is_finite(c) || !is_finite(d))
    return 0;
  switch (CGAL::orientation(point(a), point(b), point(c), point(d))) {
    case CGAL::POSITIVE:
      return 1;
    case CGAL::NEGATIVE:
      return -1;
    default:
      return 0;
  }
}

bool triangles_intersect(const std::array<vec3, 3>& a, const std::array<vec3, 3>& b) {
  return CGAL::do_intersect(kernel::Triangle_3(point(a[0]), point(a[1]), point(a[2])),
                            kernel::Triangle_3(point(b[0]), point(b[1]), point(b[2])));
}

}  // namespace tedit
