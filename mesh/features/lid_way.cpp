// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/lid_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tedit {

namespace {

/// Sines and cosines: walls that go one way, planes that cross, and a way that leads out of a lid.
constexpr double goes_along = 1e-6;
constexpr double planes_cross = 1e-2;
constexpr double leads_out = 0.2;

using kind = surface_geometry::kind;

std::optional<vec3> common_way(std::span<const surface_geometry> walls) {
  std::optional<vec3> way;
  for (const auto& one : walls) {
    if (one.type == kind::cylinder)
      way = one.axis;
    else if (one.type != kind::plane)
      return std::nullopt;
    for (const auto& other : walls)
      if (const vec3 both = cross(one.axis, other.axis);
          !way && other.type == kind::plane && norm(both) > planes_cross)
        way = normalized(both);
  }
  const bool is_common =
    way && std::ranges::all_of(walls, [&](const surface_geometry& one) {
      const double along = std::abs(dot(one.axis, *way));
      return one.type == kind::plane ? along < goes_along : along > 1 - goes_along;
    });
  return is_common ? way : std::nullopt;
}

}  // namespace

vec3 way_past_lid(std::span<const surface_geometry> walls, vec3 outward,
                  std::span<const std::array<vec3, 2>> rim) {
  const auto way = common_way(walls);
  if (!way)
    return outward;
  const double out = dot(*way, outward);
  const bool runs_along = std::ranges::any_of(rim, [&](const std::array<vec3, 2>& edge) {
    const vec3 along = edge[1] - edge[0];
    return norm(cross(along, *way)) < leads_out * norm(along);
  });
  return std::abs(out) < leads_out || runs_along ? outward : std::copysign(1.0, out) * *way;
}

double reach_of_hole(std::span<const std::vector<lid_hit>> rays, double edge) {
  double out = 0;
  for (const auto& ray : rays)
    if (!ray.empty() && ray.front().leaves)
      out = std::max(out, ray.front().distance);
  double free = std::numeric_limits<double>::infinity();
  for (const auto& ray : rays)
    for (const auto& hit : ray)
      if (!hit.leaves && hit.distance > out + lid_rules::on_surface * edge)
        free = std::min(free, hit.distance - out);
  return out + std::min(lid_rules::out_of_part * edge, lid_rules::of_gap * free);
}

}  // namespace tedit
