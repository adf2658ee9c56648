// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/exact_wall.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/features/by_most.hpp"
#include "mesh/features/torus_fit.hpp"

namespace tedit {

namespace {

constexpr fit_limits exact_limits{1e-4, true, true};
/// A sphere of which so little is there is as well a plane or free form.
constexpr double widest_sphere = 100;
/// Four numbers and few points: these must fit the better.
constexpr std::size_t fewest_on_sphere = 6;
constexpr std::size_t enough_on_sphere = 8;
constexpr double few_roundness = 1e-6;
/// Its corners are no box's: no edge is seen from the centre as wide as this, as a share of the
/// radius.
constexpr double widest_edge = 1.1;

/// Of a cone's radius: how round its tip is taken to be.
constexpr double tip_share = 1e-3;
constexpr double degree = std::numbers::pi / 180;
/// Gaps between corners around an axis, where some of the way around is not of the wall, and where
/// all of it is.
constexpr double widest_gap_angle = 75 * degree;
constexpr double widest_closed_gap = 55 * degree;

/// What is this near to its walls, as a share of their radius, is on them.
constexpr double on_its_wall = 1e-13;
constexpr double rounding = 2e-15;
/// Walls that touch without crossing are as far apart as their fits allow: there so near is near
/// enough.
constexpr double touching = exact_limits.roundness;
/// A share of the least radius: no chord is so far from its arc.
constexpr double furthest_move = 0.5;
constexpr int most_wall_steps = 40;
/// A demand that changes by less than this in the directions that others leave free follows from
/// them.
constexpr double least_slope = 1e-4;
/// Walls that meet at less than 35 degrees run on smoothly.
constexpr double runs_on_cosine = 0.82;

/// Of more triangles a tenth is tried first: a free form is dear to fit.
constexpr std::size_t many_triangles = 2000;

facet_corners each_tenth_of(const facet_corners& wall) {
  std::vector<std::array<std::uint32_t, 3>> some;
  for (std::size_t i = 0; i < wall.triangles.size(); i += 10)
    some.push_back(wall.triangles[i]);
  return with_own_points(wall.points, some);
}

struct ball {
  vec3 centre;
  double radius = 0;  ///< m
};

/// The sphere that all points lie on; nothing for fewer than six, for others, and for one that is
/// too large to be told from a plane.
std::optional<ball> fit_ball(std::span<const vec3> points) {
  if (points.size() < fewest_on_sphere)
    return std::nullopt;
  const double roundness =
    points.size() < enough_on_sphere ? few_roundness : exact_limits.roundness;
  vec3 middle;
  for (const auto& p : points)
    middle += p / static_cast<double>(points.size());
  // |p|^2 = 2 c . p + d is linear in centre and radius.
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
  const bool round = std::ranges::all_of(
    points, [&](vec3 p) { return std::abs(norm(p - middle - c) - radius) <= roundness * radius; });
  return round ? std::optional(ball{middle + c, radius}) : std::nullopt;
}

std::optional<exact_wall> sphere_of(const facet_corners& cloud) {
  const auto& points = cloud.points;
  const auto found = fit_ball(points);
  if (!found)
    return std::nullopt;
  const bool fine = std::ranges::all_of(cloud.triangles, [&](const auto& t) {
    for (int i = 0; i < 3; ++i)
      if (norm(points[t[(i + 1) % 3]] - points[t[i]]) > widest_edge * found->radius)
        return false;
    return true;
  });
  if (!fine)
    return std::nullopt;
  exact_wall result;
  result.shape.point = found->centre;
  result.sphere_radius = found->radius;
  return result;
}

/// The plane that most points are on, from one that is near.
void bring_to_most(std::span<const vec3> points, wall_shape& plane) {
  std::vector<double> off(points.size());
  double size = 0;
  for (const auto& p : points)
    size = std::max(size, norm(p - plane.point));
  for (int round = 0; round < rounds_by_most; ++round) {
    for (std::size_t i = 0; i < points.size(); ++i)
      off[i] = std::abs(dot(points[i] - plane.point, plane.axis));
    if (std::ranges::max(off) <= rounding * size)
      return;
    const auto weights = weights_by_most(off, rounding * size);
    vec3 centre;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      centre += weights[i] * points[i];
      sum += weights[i];
    }
    plane.point = centre / sum;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const vec3 d = points[i] - plane.point;
      const Eigen::Vector3d v(d.x, d.y, d.z);
      spread += weights[i] * v * v.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(spread);
    const Eigen::Vector3d n = solved.eigenvectors().col(0);
    const vec3 normal{n[0], n[1], n[2]};
    plane.axis = dot(normal, plane.axis) < 0 ? -normal : normal;
  }
}

std::optional<exact_wall> torus_of(const facet_corners& cloud) {
  const auto found = fit_torus(cloud);
  if (!found)
    return std::nullopt;
  exact_wall result;
  result.shape.point = found->centre;
  result.shape.axis = found->axis;
  result.shape.radius = found->radius;
  result.tube_radius = found->tube_radius;
  return result;
}

/// From the middle of a torus' tube to p.
vec3 from_tube(const wall_shape& ring, vec3 p) {
  const vec3 d = p - ring.point;
  const vec3 across = d - dot(d, ring.axis) * ring.axis;
  return d - ring.radius * normalized(across);
}

/// What each demand misses at a point, and how that changes.
std::vector<exact_wall::reading> read_at(const std::vector<wall_demand>& demands, vec3 p) {
  std::vector<exact_wall::reading> result;
  for (const auto& d : demands)
    result.push_back(d.wall ? d.wall->at(p)
                            : exact_wall::reading{dot(d.normal, p - d.point), d.normal});
  return result;
}

double worst_of(const std::vector<exact_wall::reading>& readings) {
  double worst = 0;
  for (const auto& one : readings)
    worst = std::max(worst, std::abs(one.distance));
  return worst;
}

/// The shortest step that fulfils the demands to first order, as far as they are independent.
vec3 step_from(const std::vector<exact_wall::reading>& readings) {
  std::array<vec3, 3> basis;
  std::size_t rank = 0;
  vec3 step;
  for (const auto& [missing, slope] : readings) {
    vec3 rest = slope;
    for (std::size_t i = 0; i < rank; ++i)
      rest = rest - dot(rest, basis[i]) * basis[i];
    const double size = norm(rest);
    if (rank == basis.size() || size < least_slope)
      continue;
    basis[rank] = rest / size;
    step -= (missing + dot(slope, step)) / size * basis[rank];
    ++rank;
  }
  return step;
}

std::vector<wall_demand> without_smooth(const std::vector<wall_demand>& all, vec3 start) {
  std::vector<wall_demand> result;
  for (const auto& d : all)
    if (!d.free_form || std::ranges::none_of(all, [&](const wall_demand& other) {
          return other.wall && std::abs(dot(other.wall->normal(start), d.normal)) > runs_on_cosine;
        }))
      result.push_back(d);
  return result;
}

}  // namespace

double exact_wall::distance(vec3 p) const {
  if (free_form) {
    const auto foot = (*free_form)(p);
    return shape.side * dot(p - foot.at, foot.normal);
  }
  if (tube_radius > 0)
    return shape.side * (norm(from_tube(shape, p)) - tube_radius);
  return sphere_radius > 0 ? shape.side * (norm(p - shape.point) - sphere_radius)
                           : shape.distance(p);
}

vec3 exact_wall::normal(vec3 p) const {
  if (free_form)
    return shape.side * (*free_form)(p).normal;
  if (tube_radius > 0)
    return shape.side * normalized(from_tube(shape, p));
  return sphere_radius > 0 ? shape.side * normalized(p - shape.point) : shape.normal(p);
}

exact_wall::reading exact_wall::at(vec3 p) const {
  if (!free_form)
    return {distance(p), normal(p)};
  const auto foot = (*free_form)(p);
  return {shape.side * dot(p - foot.at, foot.normal), shape.side * foot.normal};
}

double exact_wall::radius_at(vec3 p) const {
  if (free_form)
    return free_form->radius_at(p);
  if (sphere_radius > 0 || tube_radius > 0)
    return sphere_radius + tube_radius;
  if (flat())
    return std::numeric_limits<double>::infinity();
  return std::max(shape.radius + shape.slope * dot(p - shape.point, shape.axis),
                  tip_share * shape.radius);
}

std::optional<exact_wall> fit_exact(const facet_corners& wall) {
  if (wall.triangles.empty())
    return std::nullopt;
  if (wall.triangles.size() > many_triangles && !fit_exact(each_tenth_of(wall)))
    return std::nullopt;
  if (auto shape = fit_wall(wall.points, wall.triangles, exact_limits)) {
    if (shape->type == wall_shape::kind::plane)
      bring_to_most(wall.points, *shape);
    return exact_wall{*shape};
  }
  auto round = sphere_of(wall);
  if (!round)
    round = torus_of(wall);
  if (round)
    turn_outward(wall, *round);
  return round;
}

void turn_outward(const facet_corners& facets, exact_wall& wall) {
  double outward = 0;
  for (const auto& t : facets.triangles) {
    const std::array p{facets.points[t[0]], facets.points[t[1]], facets.points[t[2]]};
    outward += dot(cross(p[1] - p[0], p[2] - p[0]), wall.normal((p[0] + p[1] + p[2]) / 3));
  }
  if (outward >= 0)
    return;
  if (wall.flat())
    wall.shape.axis = -wall.shape.axis;
  else
    wall.shape.side = -wall.shape.side;
}

bool has_round_corners(const exact_wall& wall, std::span<const vec3> points) {
  if (wall.sphere_radius > 0 || wall.is_known)
    return true;
  const auto [first, second] = gaps_around(wall.shape, points);
  return first < widest_gap_angle ? first <= widest_closed_gap : second <= widest_gap_angle;
}

std::array<double, 2> gaps_around(const wall_shape& shape, std::span<const vec3> points) {
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

wall_place place_on_walls(const std::vector<wall_demand>& all, vec3 start) {
  const auto demands = without_smooth(all, start);
  double radius = std::numeric_limits<double>::infinity();
  for (const auto& d : demands)
    if (d.wall)
      radius = std::min(radius, d.wall->radius_at(start));
  wall_place result;
  result.at = start;
  auto readings = read_at(demands, start);
  result.before = result.after = worst_of(readings);
  // Planes alone take one step.
  if (std::isfinite(radius) && result.before <= on_its_wall * radius) {
    result.found = true;
    return result;
  }
  double near = touching * radius;
  for (const auto& d : demands)
    if (d.wall)
      near = std::max(near, d.wall->vague);
  result.found = std::isfinite(radius) && result.before <= near;
  vec3 p = start;
  for (int i = 0; i < most_wall_steps; ++i) {
    const vec3 step = step_from(readings);
    p += step;
    if (!is_finite(p) || norm(p - start) > furthest_move * radius)
      return result;
    readings = read_at(demands, p);
    const double off = worst_of(readings);
    if (off > rounding * radius && norm(step) > rounding * radius && i + 1 < most_wall_steps)
      continue;
    if (off > near || (result.found && off > result.before))
      return result;
    result.at = p;
    result.after = off;
    result.found = true;
    return result;
  }
  return result;
}

}  // namespace tedit
