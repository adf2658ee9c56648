// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/wall_shape.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/features/known_wall.hpp"
#include "mesh/features/round_fit.hpp"

namespace tedit {

namespace {

constexpr double flatness = 1e-6;  ///< Share of a surface's size: rounding of a CAD file.
constexpr double widest_facet =
  0.25;                           ///< Cosine: a facet of a cylinder is less than 75 degrees wide.
constexpr double steepest = 0.7;  ///< Cosine between a facet of a cylinder and its axis, at most.
constexpr double steepest_cone = 20;  ///< Slope: half an opening of 87 degrees.

vec3 to_vec3(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

using corners3 = std::array<std::uint32_t, 3>;

struct cloud {
  std::span<const vec3> points;
  std::span<const corners3> triangles;
  vec3 centre;
  double size = 0;
  vec3 area;                                          ///< Sum of the area vectors.
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();  ///< Area-weighted sum of n n^T.

  [[nodiscard]] vec3 area_of(const corners3& t) const {
    return area_vector(points[t[0]], points[t[1]], points[t[2]]);
  }
};

cloud gather(std::span<const vec3> points, std::span<const corners3> triangles) {
  cloud result{points, triangles, {}, 0, {}};
  for (const auto& t : triangles) {
    const vec3 area = result.area_of(t);
    result.area += area;
    const vec3 n = normalized(area);
    const Eigen::Vector3d e(n.x, n.y, n.z);
    result.normals += norm(area) * e * e.transpose();
  }
  for (const auto& p : points)
    result.centre += p / static_cast<double>(points.size());
  for (const auto& p : points)
    result.size = std::max(result.size, norm(p - result.centre));
  return result;
}

std::optional<wall_shape> fit_plane(const cloud& points) {
  wall_shape shape;
  shape.point = points.centre;
  shape.axis = normalized(points.area);
  // The wall of a square hole has no direction at all.
  if (shape.axis == vec3{})
    return std::nullopt;
  for (const auto& p : points.points)
    if (!(std::abs(shape.distance(p)) <= flatness * points.size))
      return std::nullopt;
  return shape;
}

/// Is no gap between corners around the axis as wide as a quarter turn, but for an open side? The
/// corners of a square boss lie on a cylinder, too.
bool goes_round(const wall_shape& shape, const cloud& points) {
  const vec3 helper = std::abs(shape.axis.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  const vec3 u = normalized(cross(helper, shape.axis));
  const vec3 w = cross(shape.axis, u);
  std::vector<double> angles;
  for (const auto& p : points.points)
    angles.push_back(std::atan2(dot(p - shape.point, w), dot(p - shape.point, u)));
  std::ranges::sort(angles);
  std::vector<double> gaps{angles.front() + 2 * std::numbers::pi - angles.back()};
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    gaps.push_back(angles[i + 1] - angles[i]);
  std::ranges::sort(gaps, std::greater{});
  return gaps.size() < 2 || std::cos(gaps[1]) >= widest_facet;
}

bool facets_are_narrow(const cloud& points, const wall_shape& shape) {
  return std::ranges::all_of(points.triangles, [&](const corners3& t) {
    for (int i = 0; i < 3; ++i)
      if (dot(shape.normal(points.points[t[i]]), shape.normal(points.points[t[(i + 1) % 3]])) <
          widest_facet)
        return false;
    return true;
  });
}

/// On which side of the shape the material lies.
double side_of(const cloud& points, const wall_shape& shape) {
  double outward = 0;
  for (const auto& t : points.triangles) {
    const auto& p = points.points;
    outward += dot(points.area_of(t), shape.normal((p[t[0]] + p[t[1]] + p[t[2]]) / 3));
  }
  return outward > 0 ? 1 : -1;
}

bool is_near(const wall_shape& shape, const cloud& points, double roundness) {
  return std::ranges::all_of(
    points.points, [&](vec3 p) { return std::abs(shape.distance(p)) <= roundness * shape.radius; });
}

std::optional<wall_shape> fit_cylinder(const cloud& points, const fit_limits& limits) {
  if (points.points.size() < 6)
    return std::nullopt;
  wall_shape shape;
  shape.type = wall_shape::kind::cylinder;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(points.normals);
  shape.axis = to_vec3(solver.eigenvectors().col(0));
  const vec3 u = to_vec3(solver.eigenvectors().col(1));
  const vec3 w = cross(shape.axis, u);
  // The circle through the points seen along the axis: x^2 + y^2 = 2 a x + 2 b y + c.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& p : points.points) {
    const vec3 d = p - points.centre;
    const Eigen::Vector3d row(2 * dot(d, u), 2 * dot(d, w), 1);
    normal += row * row.transpose();
    right += row * 0.25 * (row[0] * row[0] + row[1] * row[1]);
  }
  const Eigen::Vector3d circle = normal.fullPivLu().solve(right);
  shape.point = points.centre + circle[0] * u + circle[1] * w;
  shape.radius = std::sqrt(circle[2] + circle[0] * circle[0] + circle[1] * circle[1]);
  if (!(shape.radius > 0) || !(shape.radius < 100 * points.size))
    return std::nullopt;
  refine_round_wall(points.points, points.size, shape);
  const bool upright = std::ranges::all_of(points.triangles, [&](const corners3& t) {
    const vec3 area = points.area_of(t);
    return std::abs(dot(area, shape.axis)) <= steepest * norm(area);
  });
  if (!upright ||
      !(limits.wide_facets ? goes_round(shape, points) : facets_are_narrow(points, shape)))
    return std::nullopt;
  shape.side = side_of(points, shape);
  return is_near(shape, points, limits.roundness) ? std::optional(shape) : std::nullopt;
}

/// The planes of a cone's facets meet near its apex, and their normals lie on a circle around its
/// axis.
std::optional<wall_shape> fit_cone(const cloud& points, const fit_limits& limits) {
  if (points.points.size() < 7)
    return std::nullopt;
  double total = 0;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& t : points.triangles) {
    const vec3 area = points.area_of(t);
    const vec3 n = normalized(area);
    total += norm(area);
    right +=
      norm(area) * dot(n, points.points[t[0]] - points.centre) * Eigen::Vector3d(n.x, n.y, n.z);
  }
  const Eigen::Vector3d mean = Eigen::Vector3d(points.area.x, points.area.y, points.area.z) / total;
  const Eigen::Matrix3d spread = points.normals / total - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const vec3 apex = points.centre + to_vec3(points.normals.fullPivLu().solve(right));
  wall_shape shape;
  shape.type = wall_shape::kind::cone;
  shape.axis = to_vec3(solver.eigenvectors().col(0));
  const double height = dot(points.centre - apex, shape.axis);
  shape.point = apex + height * shape.axis;
  double rho = 0;
  for (const auto& p : points.points) {
    const vec3 d = p - shape.point;
    rho += norm(d - dot(d, shape.axis) * shape.axis) / static_cast<double>(points.points.size());
  }
  shape.radius = rho;
  shape.slope = rho / height;
  if (!std::isfinite(shape.slope) || std::abs(shape.slope) > steepest_cone)
    return std::nullopt;
  refine_round_wall(points.points, points.size, shape);
  const bool one_side = std::ranges::all_of(points.points, [&](vec3 p) {
    return shape.radius + shape.slope * dot(p - shape.point, shape.axis) >=
           -limits.roundness * shape.radius;
  });
  if (!(shape.radius > 0) || !one_side || !goes_round(shape, points))
    return std::nullopt;
  shape.side = side_of(points, shape);
  return is_near(shape, points, limits.roundness) ? std::optional(shape) : std::nullopt;
}

/// Nothing for what is none of these, or where a corner is further off than may be.
std::optional<wall_shape> as_shape(const exact_wall& known, const facet_corners& corners,
                                   const fit_limits& limits) {
  const auto& shape = known.shape;
  if (known.sphere_radius > 0 || known.tube_radius > 0 ||
      (shape.type == wall_shape::kind::cone && !limits.cones))
    return std::nullopt;
  const bool is_near = known.flat() || std::ranges::all_of(corners.points, [&](vec3 p) {
                         return std::abs(shape.distance(p)) <= limits.roundness * shape.radius;
                       });
  return is_near ? std::optional(shape) : std::nullopt;
}

}  // namespace

void refine_round_wall(std::span<const vec3> points, double size, wall_shape& shape) {
  const bool cone = shape.type == wall_shape::kind::cone;
  for (int step = 0; step < 20; ++step) {
    const vec3 helper = std::abs(shape.axis.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    const vec3 u = normalized(cross(helper, shape.axis));
    const vec3 w = cross(shape.axis, u);
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (const auto& p : points) {
      const vec3 d = p - shape.point;
      const double along = dot(d, shape.axis);
      const vec3 off = d - along * shape.axis;
      const double rho = norm(off);
      if (!(rho > 0))
        continue;
      const vec3 radial = off / rho;
      const double lever = (along + shape.slope * rho) / size;
      Eigen::Matrix<double, 6, 1> row;
      row << -dot(radial, u), -dot(radial, w), -lever * dot(radial, u), -lever * dot(radial, w), -1,
        cone ? -along / size : 0;
      normal += row * row.transpose();
      right -= row * (rho - shape.radius - shape.slope * along);
    }
    if (!cone)
      normal(5, 5) = 1;
    const Eigen::Matrix<double, 6, 1> x = normal.ldlt().solve(right);
    if (!x.allFinite())
      return;
    shape.point += x[0] * u + x[1] * w;
    shape.axis = normalized(shape.axis + (x[2] * u + x[3] * w) / size);
    shape.radius += x[4];
    shape.slope += x[5] / size;
    if (x.norm() <= 1e-14 * size)
      return;
  }
}

double wall_shape::distance(vec3 p) const {
  const vec3 d = p - point;
  if (type == kind::plane)
    return dot(axis, d);
  const double along = dot(d, axis);
  return side * (norm(d - along * axis) - radius - slope * along) / std::hypot(1, slope);
}

vec3 wall_shape::normal(vec3 p) const {
  if (type == kind::plane)
    return axis;
  const vec3 d = p - point;
  return side / std::hypot(1, slope) * (normalized(d - dot(d, axis) * axis) - slope * axis);
}

facet_corners corners_of(const mesh_version& mesh, std::span<const facet_id> facets) {
  std::vector<vertex_id> ids;
  for (const auto f : facets)
    ids.insert(ids.end(), mesh.facet(f).v.begin(), mesh.facet(f).v.end());
  std::ranges::sort(ids);
  ids.erase(std::ranges::unique(ids).begin(), ids.end());
  facet_corners result;
  for (const auto v : ids)
    result.points.push_back(mesh.position(v));
  for (const auto f : facets) {
    std::array<std::uint32_t, 3> t{};
    for (int i = 0; i < 3; ++i)
      t[i] =
        static_cast<std::uint32_t>(std::ranges::lower_bound(ids, mesh.facet(f).v[i]) - ids.begin());
    result.triangles.push_back(t);
  }
  return result;
}

facet_corners with_own_points(std::span<const vec3> points,
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

std::optional<wall_shape> fit_wall(std::span<const vec3> points,
                                   std::span<const std::array<std::uint32_t, 3>> triangles,
                                   const fit_limits& limits) {
  if (triangles.empty())
    return std::nullopt;
  const auto all = gather(points, triangles);
  auto shape = fit_plane(all);
  if (!shape)
    shape = fit_cylinder(all, limits);
  if (!shape && limits.cones)
    shape = fit_cone(all, limits);
  return shape;
}

std::optional<wall_shape> fit_wall(const mesh_version& mesh, std::span<const facet_id> facets,
                                   const fit_limits& limits) {
  const auto corners = corners_of(mesh, facets);
  if (const auto known = known_wall(mesh, facets, corners); known && !known->free_form)
    return as_shape(*known, corners, limits);
  return fit_wall(corners.points, corners.triangles, limits);
}

}  // namespace tedit
