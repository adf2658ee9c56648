// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/wall_spot.hpp"

#include <algorithm>
#include <cmath>

#include "client-qt/model/circle_fit.hpp"
#include "client-qt/model/probes.hpp"

namespace tedit::desktop {

namespace {

using corners = std::array<vec3, 3>;

/// Twice the area, along the normal.
vec3 area_vector(const corners& c) {
  return cross(c[1] - c[0], c[2] - c[0]);
}

template <class Visit>
void each_facet(const client::surface_model& part, const std::vector<surface_id>& of,
                const Visit& visit) {
  part.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    if (!of.empty() && std::ranges::find(of, facet.surface) == of.end())
      return;
    corners c;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto* p = part.positions().find(facet.v[k]);
      if (!p)
        return;
      c[k] = *p;
    }
    visit(c);
  });
}

std::optional<wall_spot> nearest_spot(const client::surface_model& part, const vec3& to,
                                      const std::vector<surface_id>& of) {
  std::optional<wall_spot> best;
  double least = INFINITY;
  each_facet(part, of, [&](const corners& c) {
    const vec3 at = nearest_on(c, to);
    const double far = dot(at - to, at - to);
    if (far < least) {
      least = far;
      best = wall_spot{at, normalized(area_vector(c))};
    }
  });
  return best;
}

/// The direction that the normals of some triangles have least of: across those of a cylinder. The
/// pair of normals that are most across each other says it best.
std::optional<vec3> axis_of(const std::vector<vec3>& normals) {
  constexpr double least_sine = 0.5;  // Of what they turn by.
  if (normals.empty())
    return std::nullopt;
  vec3 best;
  for (const auto& n : normals)
    if (const vec3 z = cross(normals.front(), n); norm(z) > norm(best))
      best = z;
  if (norm(best) < least_sine)
    return std::nullopt;
  const vec3 z = normalized(best);
  const bool all_across =
    std::ranges::all_of(normals, [&](const vec3& n) { return std::abs(dot(n, z)) < 0.02; });
  return all_across ? std::optional(z) : std::nullopt;
}

/// The corners of a box are on a circle, too: there normals are far off the way to the middle.
bool points_outward(const std::vector<vec3>& points, const std::vector<vec3>& normals,
                    const vec3& middle, const vec3& axis) {
  const double least_cosine = std::cos(0.7);  // Half a segment of a coarse bore; a box has 0.785.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec3 away = points[i] - middle;
    const vec3 radial = normalized(away - dot(away, axis) * axis);
    if (std::abs(dot(radial, normals[i / 3])) < least_cosine)
      return false;
  }
  return true;
}

}  // namespace

std::optional<wall_spot> middle_of(const client::surface_model& part, surface_id surface) {
  vec3 sum;
  double area = 0;
  each_facet(part, {surface}, [&](const corners& c) {
    const double share = norm(area_vector(c));
    sum += share * (c[0] + c[1] + c[2]) / 3;
    area += share;
  });
  if (!(area > 0))
    return std::nullopt;
  return nearest_spot(part, sum / area, {surface});
}

std::optional<vec3> outward_at(const client::surface_model& part, const vec3& at,
                               const std::vector<surface_id>& of) {
  const auto spot = nearest_spot(part, at, of);
  return spot ? std::optional(spot->normal) : std::nullopt;
}

std::optional<round_wall> round_wall_of(const client::surface_model& part,
                                        const std::vector<surface_id>& surfaces) {
  if (surfaces.empty())
    return std::nullopt;
  std::vector<vec3> normals;
  std::vector<vec3> points;
  each_facet(part, surfaces, [&](const corners& c) {
    normals.push_back(normalized(area_vector(c)));
    points.insert(points.end(), c.begin(), c.end());
  });
  const auto axis = axis_of(normals);
  if (!axis)
    return std::nullopt;
  const auto [x, y] = across(*axis);
  std::vector<std::array<double, 2>> flat;
  double low = INFINITY;
  double high = -INFINITY;
  for (const auto& p : points) {
    flat.push_back({dot(p, x), dot(p, y)});
    low = std::min(low, dot(p, *axis));
    high = std::max(high, dot(p, *axis));
  }
  const auto circle = fit_circle(flat);
  if (!circle || circle->worst > 0.01 * circle->radius)
    return std::nullopt;
  const vec3 middle = circle->middle[0] * x + circle->middle[1] * y + (low + high) / 2 * *axis;
  if (!points_outward(points, normals, middle, *axis))
    return std::nullopt;
  return round_wall{middle, *axis, circle->radius};
}

}  // namespace tedit::desktop
