// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/step_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::ops {

namespace {

/// Sine of the angle between directions that are one.
constexpr double one_way = 1e-6;
/// So far off its circle may a point of the rim be, as a share of the radius: where a fillet runs
/// out on a plane corners slide along both.
constexpr double off_circle = 1e-4;

bool goes_round(const surface_geometry& beside, vec3 way) {
  using kind = surface_geometry::kind;
  switch (beside.type) {
    case kind::sphere:
      return true;
    case kind::cylinder:
    case kind::cone:
    case kind::torus:
      return norm(cross(beside.axis, way)) < one_way;
    case kind::none:
    case kind::plane:
    case kind::spline:
      return false;
  }
  return false;
}

}  // namespace

surface_geometry step_geometry(const surface_geometry& beside, std::span<const vec3> rim,
                               vec3 way) {
  if (rim.empty() || !goes_round(beside, way))
    return {};
  double least = 1e300;
  double most = 0;
  for (const auto& p : rim) {
    const double radius = norm(cross(p - beside.point, way));
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  const double radius = 0.5 * (least + most);
  if (!(most - least <= 2 * off_circle * radius))
    return {};
  surface_geometry step;
  step.type = surface_geometry::kind::cylinder;
  step.point = beside.point;
  step.axis = way;
  step.radius = radius;
  step.tolerance = 0.5 * (most - least);
  return step;
}

}  // namespace tedit::ops
