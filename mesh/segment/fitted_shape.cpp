// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/segment/fitted_shape.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mesh/features/round_fit.hpp"

namespace tedit {

namespace {

constexpr double steepest_slope = 20;  ///< Of a cone: half an opening of 87 degrees.
constexpr double widest_turn = 1000;   ///< Radius in terms of the points' extent: flatter is flat.

Eigen::Vector3d to_eigen(vec3 v) {
  return {v.x, v.y, v.z};
}

vec3 from_eigen(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// Sums over a sample that several fits need.
struct sums {
  vec3 centre;
  double size = 0;
  double area = 0;
  vec3 mean_normal;
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();  ///< Mean of n n^T by area.
};

sums sums_of(const fit_sample& sample) {
  sums result;
  for (const auto& p : sample.points)
    result.centre += p / static_cast<double>(sample.points.size());
  for (const auto& p : sample.points)
    result.size = std::max(result.size, norm(p - result.centre));
  for (const auto& f : sample.facets) {
    const double area = norm(f.area);
    const auto n = to_eigen(normalized(f.area));
    result.area += area;
    result.mean_normal += f.area;
    result.normals += area * n * n.transpose();
  }
  if (result.area > 0) {
    result.normals /= result.area;
    result.mean_normal = result.mean_normal / result.area;
  }
  return result;
}

/// A guess that is far off is not worth its refinement.
bool is_near(const fitted_shape& shape, const fit_sample& sample, const sums& all) {
  constexpr double far = 0.05;
  return std::ranges::all_of(sample.points,
                             [&](vec3 p) { return shape.distance(p) <= far * all.size; });
}

fitted_shape plane_of(const sums& all) {
  fitted_shape shape{surface_form::plane, {}};
  shape.wall.point = all.centre;
  shape.wall.axis = normalized(all.mean_normal);
  return shape;
}

bool is_round(const fitted_shape& shape, const sums& all) {
  return std::isfinite(shape.wall.radius) && shape.wall.radius > 0 &&
         shape.wall.radius < widest_turn * all.size && is_finite(shape.wall.point);
}

/// The circle through the points seen along the axis: x^2 + y^2 = 2 a x + 2 b y + c.
std::optional<fitted_shape> cylinder_of(const fit_sample& sample, const sums& all) {
  fitted_shape shape{surface_form::cylinder, {}};
  shape.wall.type = wall_shape::kind::cylinder;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(all.normals);
  shape.wall.axis = from_eigen(solver.eigenvectors().col(0));
  const vec3 u = from_eigen(solver.eigenvectors().col(1));
  const vec3 w = cross(shape.wall.axis, u);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& p : sample.points) {
    const vec3 d = (p - all.centre) / all.size;
    const Eigen::Vector3d row(2 * dot(d, u), 2 * dot(d, w), 1);
    normal += row * row.transpose();
    right += row * 0.25 * (row[0] * row[0] + row[1] * row[1]);
  }
  const Eigen::Vector3d circle = all.size * normal.fullPivLu().solve(right);
  shape.wall.point = all.centre + circle[0] * u + circle[1] * w;
  shape.wall.radius =
    std::sqrt(circle[2] * all.size + circle[0] * circle[0] + circle[1] * circle[1]);
  if (!is_round(shape, all) || !is_near(shape, sample, all))
    return std::nullopt;
  refine_round_wall(sample.points, all.size, shape.wall);
  return is_round(shape, all) ? std::optional(shape) : std::nullopt;
}

/// The planes of a cone's facets meet near its apex, and their normals lie on a circle around its
/// axis.
std::optional<fitted_shape> cone_of(const fit_sample& sample, const sums& all) {
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& f : sample.facets) {
    const vec3 n = normalized(f.area);
    right += norm(f.area) / all.area * dot(n, f.point - all.centre) * to_eigen(n);
  }
  const auto mean = to_eigen(all.mean_normal);
  const Eigen::Matrix3d spread = all.normals - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const vec3 apex = all.centre + from_eigen(all.normals.fullPivLu().solve(right));
  fitted_shape shape{surface_form::cone, {}};
  shape.wall.type = wall_shape::kind::cone;
  shape.wall.axis = from_eigen(solver.eigenvectors().col(0));
  const double height = dot(all.centre - apex, shape.wall.axis);
  shape.wall.point = apex + height * shape.wall.axis;
  for (const auto& p : sample.points) {
    const vec3 d = p - shape.wall.point;
    shape.wall.radius += norm(d - dot(d, shape.wall.axis) * shape.wall.axis) /
                         static_cast<double>(sample.points.size());
  }
  shape.wall.slope = shape.wall.radius / height;
  if (!is_round(shape, all) || !(std::abs(shape.wall.slope) < steepest_slope) ||
      !is_near(shape, sample, all))
    return std::nullopt;
  refine_round_wall(sample.points, all.size, shape.wall);
  const bool one_side = std::ranges::all_of(sample.points, [&](vec3 p) {
    return shape.wall.radius + shape.wall.slope * dot(p - shape.wall.point, shape.wall.axis) >=
           -1e-3 * shape.wall.radius;
  });
  if (!is_round(shape, all) || !one_side || !(std::abs(shape.wall.slope) < steepest_slope))
    return std::nullopt;
  return shape;
}

/// |p|^2 = 2 c p + k.
std::optional<fitted_shape> sphere_of(const fit_sample& sample, const sums& all) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const auto& p : sample.points) {
    const vec3 d = (p - all.centre) / all.size;
    const Eigen::Vector4d row(2 * d.x, 2 * d.y, 2 * d.z, 1);
    normal += row * row.transpose();
    right += row * dot(d, d);
  }
  const Eigen::Vector4d found = normal.fullPivLu().solve(right);
  const vec3 c{found[0], found[1], found[2]};
  fitted_shape shape{surface_form::sphere, {}};
  shape.wall.point = all.centre + all.size * c;
  shape.wall.radius = all.size * std::sqrt(found[3] + dot(c, c));
  return is_round(shape, all) ? std::optional(shape) : std::nullopt;
}

}  // namespace

std::string_view name_of(surface_form form) {
  switch (form) {
    case surface_form::plane:
      return "plane";
    case surface_form::cylinder:
      return "cylinder";
    case surface_form::cone:
      return "cone";
    case surface_form::sphere:
      return "sphere";
    case surface_form::free:
      break;
  }
  return "free form";
}

double fitted_shape::distance(vec3 p) const {
  if (form == surface_form::free)
    return 0;
  if (form == surface_form::sphere)
    return std::abs(norm(p - wall.point) - wall.radius);
  return std::abs(wall.distance(p));
}

vec3 fitted_shape::normal(vec3 p) const {
  return form == surface_form::sphere ? normalized(p - wall.point) : wall.normal(p);
}

vec3 fitted_shape::project(vec3 p) const {
  if (form == surface_form::free)
    return p;
  if (form == surface_form::sphere)
    return wall.point + wall.radius * normalized(p - wall.point);
  return wall.project(p);
}

std::optional<fitted_shape> fit_shape(surface_form form, const fit_sample& sample) {
  const auto all = sums_of(sample);
  if (!(all.size > 0) || !(all.area > 0))
    return std::nullopt;
  const std::size_t count = sample.points.size();
  if (form == surface_form::plane && count >= 3)
    return plane_of(all);
  if (form == surface_form::cylinder && count >= 5)
    return cylinder_of(sample, all);
  if (form == surface_form::cone && count >= 6)
    return cone_of(sample, all);
  if (form == surface_form::sphere && count >= 4)
    return sphere_of(sample, all);
  return std::nullopt;
}

}  // namespace tedit
