// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/torus_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/features/by_most.hpp"

namespace tedit {

namespace {

constexpr double torus_roundness = 1e-4;
constexpr std::size_t fewest_corners = 10;
constexpr std::size_t enough_corners = 80;
/// Rows of corners around the tube: how far apart they must be to be two, and may be.
constexpr double same_row = 0.02;
constexpr double widest_row_gap = 55 * std::numbers::pi / 180;
/// A tube that is larger than this share of the wall's extent is as well a plane.
constexpr double widest_tube = 50;
/// With a narrower ring, as a share of the tube's radius, it is as well a sphere.
constexpr double least_ring = 0.05;
constexpr int axes_tried = 60;
constexpr std::size_t starts = 8;
constexpr int most_torus_steps = 100;
/// After so many steps no corner may be further off than this share of the tube's radius.
constexpr int first_steps = 50;
constexpr double still_far = 0.02;

using vec7 = Eigen::Matrix<double, 7, 1>;
using mat7 = Eigen::Matrix<double, 7, 7>;

/// A point as a torus sees it.
struct seen_point {
  double along = 0;  ///< From the centre, along the axis.
  double out = 0;    ///< From the axis.
  vec3 outward;      ///< Unit.
};

seen_point seen_from(const torus& t, vec3 p) {
  const vec3 d = p - t.centre;
  seen_point s;
  s.along = dot(d, t.axis);
  const vec3 across = d - s.along * t.axis;
  s.out = norm(across);
  s.outward = s.out > 0 ? across / s.out : vec3{};
  return s;
}

double off_torus(const torus& t, vec3 p) {
  const auto s = seen_from(t, p);
  return std::hypot(s.out - t.radius, s.along) - t.tube_radius;
}

double worst_off(const torus& t, std::span<const vec3> points) {
  double worst = 0;
  for (const auto& p : points)
    worst = std::max(worst, std::abs(off_torus(t, p)));
  return worst;
}

/// Corners, and how much each counts.
struct weighted_points {
  std::span<const vec3> points;
  std::vector<double> weights;

  explicit weighted_points(std::span<const vec3> all) : points(all), weights(all.size(), 1) {}
};

double sum_of_squares(const torus& t, const weighted_points& cloud) {
  double sum = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double off = off_torus(t, cloud.points[i]);
    sum += cloud.weights[i] * off * off;
  }
  return sum;
}

struct line {
  vec3 point;
  vec3 direction;  ///< Unit.
};

/// How near the normals of all triangles come to a line: two lines meet where the moment of one
/// along the other is none (Pottmann and Randrup 1998).
class normal_lines {
public:
  normal_lines(const facet_corners& wall, vec3 middle) : middle_(middle) {
    Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d by_moment = Eigen::Matrix3d::Zero();
    for (const auto& t : wall.triangles) {
      const vec3 a = wall.points[t[0]] - middle;
      const vec3 b = wall.points[t[1]] - middle;
      const vec3 c = wall.points[t[2]] - middle;
      const vec3 n = cross(b - a, c - a);
      const double size = norm(n);
      if (size == 0)
        continue;
      const vec3 m = cross((a + b + c) / 3, n / size);
      const Eigen::Vector3d normal(n.x / size, n.y / size, n.z / size);
      mixed += size * normal * Eigen::RowVector3d(m.x, m.y, m.z);
      by_moment += size * normal * normal.transpose();
    }
    moment_of_ = -by_moment.fullPivLu().solve(mixed);
  }

  /// The line of this direction that they come nearest to.
  [[nodiscard]] line along(vec3 direction) const {
    const Eigen::Vector3d d(direction.x, direction.y, direction.z);
    const Eigen::Vector3d p = d.cross(Eigen::Vector3d(moment_of_ * d));
    return {middle_ + vec3{p[0], p[1], p[2]}, direction};
  }

private:
  vec3 middle_;
  Eigen::Matrix3d moment_of_;
};

/// With a circle fitted to where the points are along the axis and from it (Kasa).
std::optional<torus> around(const line& axis, std::span<const vec3> points, vec3 middle) {
  torus t{axis.point + dot(middle - axis.point, axis.direction) * axis.direction, axis.direction};
  Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& p : points) {
    const auto s = seen_from(t, p);
    const Eigen::Vector3d row(2 * s.out, 2 * s.along, 1);
    left += row * row.transpose();
    right += row * (s.out * s.out + s.along * s.along);
  }
  const Eigen::Vector3d x = left.fullPivLu().solve(right);
  t.radius = x[0];
  t.centre += x[1] * t.axis;
  t.tube_radius = std::sqrt(x[2] + x[0] * x[0] + x[1] * x[1]);
  return std::isfinite(t.tube_radius) && t.tube_radius > 0 ? std::optional(t) : std::nullopt;
}

/// One step of the seven numbers: centre, axis (two), radius, tube's radius.
torus stepped(const torus& t, const weighted_points& cloud, double damping) {
  const vec3 u =
    normalized(cross(std::abs(t.axis.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0}, t.axis));
  const vec3 w = cross(t.axis, u);
  mat7 left = mat7::Zero();
  vec7 right = vec7::Zero();
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const auto s = seen_from(t, cloud.points[i]);
    const double h = std::max(std::hypot(s.out - t.radius, s.along), 1e-300);
    const double outward = (s.out - t.radius) / h;
    const vec3 n = outward * s.outward + s.along / h * t.axis;
    const double turned = s.along * t.radius / h;
    vec7 row;
    row << -n.x, -n.y, -n.z, turned * dot(s.outward, u), turned * dot(s.outward, w), -outward, -1;
    left += cloud.weights[i] * row * row.transpose();
    right -= cloud.weights[i] * (h - t.tube_radius) * row;
  }
  left.diagonal() *= 1 + damping;
  const vec7 x = left.ldlt().solve(right);
  torus next = t;
  next.centre += vec3{x[0], x[1], x[2]};
  next.axis = normalized(t.axis + x[3] * u + x[4] * w);
  next.radius += x[5];
  next.tube_radius += x[6];
  return next;
}

/// Levenberg and Marquardt's steps until nothing gains; nothing where they stay far off.
std::optional<torus> settled(torus t, const weighted_points& cloud, double size) {
  double sum = sum_of_squares(t, cloud);
  double damping = 1e-3;
  for (int i = 0; i < most_torus_steps; ++i) {
    if (i == first_steps && worst_off(t, cloud.points) > still_far * t.tube_radius)
      return std::nullopt;
    const auto next = stepped(t, cloud, damping);
    const double less = sum_of_squares(next, cloud);
    if (!(less < sum)) {
      damping = std::max(10 * damping, 1e-6);
      if (damping > 1e6)
        break;
      continue;
    }
    const bool ends = less > (1 - 1e-6) * sum || std::sqrt(less) < 1e-14 * size;
    t = next;
    sum = less;
    damping /= 20;
    if (ends)
      break;
  }
  return t;
}

bool is_torus(const torus& t, std::span<const vec3> points, double size) {
  return t.tube_radius > 0 && t.tube_radius < widest_tube * size &&
         t.radius > least_ring * t.tube_radius &&
         worst_off(t, points) <= torus_roundness * t.tube_radius;
}

/// The torus that most corners are on.
torus by_most(torus t, std::span<const vec3> points, double size) {
  weighted_points cloud(points);
  std::vector<double> off(points.size());
  for (int round = 0; round < rounds_by_most; ++round) {
    for (std::size_t i = 0; i < points.size(); ++i)
      off[i] = std::abs(off_torus(t, points[i]));
    cloud.weights = weights_by_most(off, 1e-13 * t.tube_radius);
    const auto next = settled(t, cloud, size);
    if (!next || !is_torus(*next, points, size))
      return t;
    t = *next;
  }
  return t;
}

/// The best of what the axes all around have, as starts.
std::vector<torus> starts_of(const facet_corners& wall, std::span<const vec3> some, vec3 middle) {
  const normal_lines lines(wall, middle);
  const weighted_points cloud(some);
  std::vector<std::pair<double, torus>> all;
  for (int i = 0; i < axes_tried; ++i) {
    // A spiral over half of the sphere.
    const double up = (i + 0.5) / axes_tried;
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double out = std::sqrt(1 - up * up);
    if (const auto t =
          around(lines.along({out * std::cos(turn), out * std::sin(turn), up}), some, middle))
      all.emplace_back(sum_of_squares(*t, cloud), *t);
  }
  std::ranges::sort(all, {}, &std::pair<double, torus>::first);
  all.resize(std::min(all.size(), starts));
  std::vector<torus> result;
  for (const auto& [sum, t] : all)
    result.push_back(t);
  return result;
}

/// Three rows at least, none far from the next.
bool has_rows(const torus& t, std::span<const vec3> points) {
  std::vector<double> angles;
  for (const auto& p : points) {
    const auto s = seen_from(t, p);
    angles.push_back(std::atan2(s.along, s.out - t.radius));
  }
  std::ranges::sort(angles);
  std::vector<double> gaps{angles.front() + 2 * std::numbers::pi - angles.back()};
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    gaps.push_back(angles[i + 1] - angles[i]);
  std::ranges::sort(gaps, std::greater{});
  // The widest one is what the fillet leaves open.
  return gaps[2] > same_row && gaps[1] <= widest_row_gap;
}

std::vector<vec3> some_of(const std::vector<vec3>& points) {
  const std::size_t stride = points.size() / enough_corners + 1;
  std::vector<vec3> result;
  for (std::size_t i = 0; i < points.size(); i += stride)
    result.push_back(points[i]);
  return result;
}

}  // namespace

std::optional<torus> fit_torus(const facet_corners& wall) {
  if (wall.points.size() < fewest_corners || wall.triangles.empty())
    return std::nullopt;
  vec3 middle;
  for (const auto& p : wall.points)
    middle += p / static_cast<double>(wall.points.size());
  double size = 0;
  for (const auto& p : wall.points)
    size = std::max(size, norm(p - middle));
  const auto some = some_of(wall.points);
  for (const auto& start : starts_of(wall, some, middle)) {
    const auto near = settled(start, weighted_points(some), size);
    if (!near || !is_torus(*near, some, size))
      continue;
    const auto found = settled(*near, weighted_points(wall.points), size);
    if (found && is_torus(*found, wall.points, size) && has_rows(*found, wall.points))
      return by_most(*found, wall.points, size);
  }
  return std::nullopt;
}

}  // namespace tedit
