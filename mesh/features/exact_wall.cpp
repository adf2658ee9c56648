// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/exact_wall.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tedit {

namespace {

constexpr double one_degree = std::numbers::pi / 180;
constexpr fit_limits exact_limits{1e-4, true, true};
/// A sphere of which so little is there is as well a plane or free form.
constexpr double widest_sphere = 100;
/// Gaps between corners around the axis: the corners of a hexagon lie on a cylinder, too.
constexpr double widest_gap = 75 * one_degree;
constexpr double widest_closed_gap = 55 * one_degree;
constexpr double widest_tool_gap = 25 * one_degree;
constexpr double widest_sphere_edge = 65 * one_degree;
constexpr double widest_tool_edge = 36 * one_degree;
/// Of more facets a part is tried first: free form is dear to fit.
constexpr std::size_t many_facets = 2000;

/// The triangles with those points alone that they have.
facet_corners compacted(std::span<const vec3> points,
                        std::span<const std::array<std::uint32_t, 3>> triangles) {
  facet_corners result;
  std::vector<std::uint32_t> used;
  for (const auto& t : triangles)
    used.insert(used.end(), t.begin(), t.end());
  std::ranges::sort(used);
  used.erase(std::ranges::unique(used).begin(), used.end());
  for (const auto v : used)
    result.points.push_back(points[v]);
  for (auto t : triangles) {
    for (auto& v : t)
      v = static_cast<std::uint32_t>(std::ranges::lower_bound(used, v) - used.begin());
    result.triangles.push_back(t);
  }
  return result;
}

/// |p|^2 = 2 c . p + d is linear in centre and radius.
std::optional<exact_wall> fit_sphere(const std::vector<vec3>& points) {
  if (points.size() < 8)
    return std::nullopt;
  vec3 middle;
  for (const auto& p : points)
    middle += p / static_cast<double>(points.size());
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  double size = 0;
  for (const auto& p : points) {
    const vec3 d = p - middle;
    const Eigen::Vector4d row(2 * d.x, 2 * d.y, 2 * d.z, 1);
    normal += row * row.transpose();
    right += row * dot(d, d);
    size = std::max(size, norm(d));
  }
  const Eigen::Vector4d x = normal.fullPivLu().solve(right);
  const vec3 c{x[0], x[1], x[2]};
  const double radius = std::sqrt(x[3] + dot(c, c));
  if (!(radius > 0) || !(radius < widest_sphere * size))
    return std::nullopt;
  const bool round = std::ranges::all_of(points, [&](vec3 p) {
    return std::abs(norm(p - middle - c) - radius) <= exact_limits.roundness * radius;
  });
  if (!round)
    return std::nullopt;
  exact_wall result;
  result.shape.point = middle + c;
  result.sphere_radius = radius;
  return result;
}

/// The two widest gaps between corners around the axis, rad, the wider one first.
std::array<double, 2> gaps_of(const wall_shape& shape, const std::vector<vec3>& points) {
  const vec3 helper = std::abs(shape.axis.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  const vec3 u = normalized(cross(helper, shape.axis));
  const vec3 w = cross(shape.axis, u);
  std::vector<double> angles;
  for (const auto& p : points) {
    const vec3 d = p - shape.point;
    // A cone's apex is on all sides.
    if (std::hypot(dot(d, u), dot(d, w)) > 1e-6 * shape.radius)
      angles.push_back(std::atan2(dot(d, w), dot(d, u)));
  }
  if (angles.empty())
    return {2 * std::numbers::pi, 0};
  std::ranges::sort(angles);
  std::vector<double> gaps{angles.front() + 2 * std::numbers::pi - angles.back()};
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    gaps.push_back(angles[i + 1] - angles[i]);
  std::ranges::sort(gaps, std::greater{});
  return {gaps[0], gaps.size() > 1 ? gaps[1] : 0};
}

bool is_round(const wall_shape& shape, const std::vector<vec3>& points, bool tool) {
  const auto [first, second] = gaps_of(shape, points);
  if (tool)
    return second <= widest_tool_gap;
  return first < widest_gap ? first <= widest_closed_gap : second <= widest_gap;
}

/// The corners of a box lie on a sphere, too: is no edge of the facets too wide, seen from its
/// centre?
bool is_fine(const exact_wall& sphere, const facet_corners& cloud, bool tool) {
  const double widest =
    2 * sphere.sphere_radius * std::sin((tool ? widest_tool_edge : widest_sphere_edge) / 2);
  return std::ranges::all_of(cloud.triangles, [&](const auto& t) {
    for (int i = 0; i < 3; ++i)
      if (norm(cloud.points[t[(i + 1) % 3]] - cloud.points[t[i]]) > widest)
        return false;
    return true;
  });
}

std::optional<exact_wall> fit(const facet_corners& cloud, bool tool) {
  if (cloud.triangles.empty())
    return std::nullopt;
  if (const auto shape = fit_wall(cloud.points, cloud.triangles, exact_limits)) {
    if (shape->type != wall_shape::kind::plane && !is_round(*shape, cloud.points, tool))
      return std::nullopt;
    return exact_wall{*shape, 0};
  }
  auto sphere = fit_sphere(cloud.points);
  return sphere && is_fine(*sphere, cloud, tool) ? std::move(sphere) : std::nullopt;
}

}  // namespace

double exact_wall::distance(vec3 p) const {
  return sphere_radius > 0 ? norm(p - shape.point) - sphere_radius : shape.distance(p);
}

vec3 exact_wall::normal(vec3 p) const {
  return sphere_radius > 0 ? normalized(p - shape.point) : shape.normal(p);
}

double exact_wall::radius_at(vec3 p) const {
  if (sphere_radius > 0)
    return sphere_radius;
  return flat() ? std::numeric_limits<double>::infinity()
                : shape.radius + shape.slope * dot(p - shape.point, shape.axis);
}

std::optional<exact_wall> fit_exact(const mesh_version& mesh, std::span<const facet_id> facets) {
  const auto cloud = corners_of(mesh, facets);
  if (facets.size() > many_facets) {
    const auto tenth = std::span(cloud.triangles).first(cloud.triangles.size() / 10);
    const auto some = compacted(cloud.points, tenth);
    if (!fit_wall(some.points, some.triangles, exact_limits) && !fit_sphere(some.points))
      return std::nullopt;
  }
  return fit(cloud, false);
}

std::optional<exact_wall> fit_exact_tool(std::span<const vec3> points,
                                         std::span<const std::array<std::uint32_t, 3>> triangles,
                                         bool of_part) {
  return fit(compacted(points, triangles), !of_part);
}

}  // namespace tedit
