// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/sdk/rolling_ball.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tedit::ops {

namespace {

constexpr double flatness = 1e-6;   ///< Share of a surface's size: rounding of a CAD file.
constexpr double roundness = 1e-4;  ///< Share of a cylinder's radius.
constexpr double widest_facet =
  0.25;                           ///< Cosine: a facet of a cylinder is less than 75 degrees wide.
constexpr double steepest = 0.7;  ///< Cosine between a facet of a cylinder and its axis, at most.
constexpr int newton_steps = 40;

struct equation {
  double value = 0;
  vec3 slope;
};

/// The point where three functions vanish, from `start`; it must stay within `reach` of it.
std::optional<vec3> solve(const std::function<std::array<equation, 3>(vec3)>& system, vec3 start,
                          double reach) {
  vec3 x = start;
  double last = 0;
  for (int step = 0; step < newton_steps; ++step) {
    const auto e = system(x);
    const vec3 c12 = cross(e[1].slope, e[2].slope);
    const double det = dot(e[0].slope, c12);
    if (!(std::abs(det) > 1e-6))
      return std::nullopt;
    const vec3 move = (e[0].value * c12 + e[1].value * cross(e[2].slope, e[0].slope) +
                       e[2].value * cross(e[0].slope, e[1].slope)) /
                      det;
    x = x - move;
    if (!is_finite(x) || norm(x - start) > reach)
      return std::nullopt;
    last = norm(move);
    if (last <= 1e-14 * reach)
      return x;
  }
  // What is left then is the rounding of the coordinates.
  return last <= 1e-9 * reach ? std::optional(x) : std::nullopt;
}

vec3 to_vec3(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

struct cloud {
  std::vector<vec3> points;
  vec3 centre;
  double size = 0;
  vec3 area;                                          ///< Sum of the area vectors.
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();  ///< Area-weighted sum of n n^T.
};

cloud gather(const mesh_version& mesh, std::span<const facet_id> facets) {
  cloud result;
  std::vector<vertex_id> corners;
  for (const auto f : facets) {
    const auto& v = mesh.facet(f).v;
    corners.insert(corners.end(), v.begin(), v.end());
    const vec3 area = area_vector(mesh, mesh.facet(f));
    result.area += area;
    const vec3 n = normalized(area);
    const Eigen::Vector3d e(n.x, n.y, n.z);
    result.normals += norm(area) * e * e.transpose();
  }
  std::ranges::sort(corners);
  corners.erase(std::ranges::unique(corners).begin(), corners.end());
  for (const auto v : corners) {
    result.points.push_back(mesh.position(v));
    result.centre += mesh.position(v) / static_cast<double>(corners.size());
  }
  for (const auto& p : result.points)
    result.size = std::max(result.size, norm(p - result.centre));
  return result;
}

std::optional<wall_shape> fit_plane(const cloud& points) {
  wall_shape shape;
  shape.point = points.centre;
  shape.axis = normalized(points.area);
  for (const auto& p : points.points)
    if (!(std::abs(shape.distance(p)) <= flatness * points.size))
      return std::nullopt;
  return shape;
}

/// Gauss-Newton on the sum of (distance from the axis - R)^2 over the axis' point and direction.
void refine(const cloud& points, wall_shape& shape) {
  for (int step = 0; step < 20; ++step) {
    const vec3 helper = std::abs(shape.axis.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    const vec3 u = normalized(cross(helper, shape.axis));
    const vec3 w = cross(shape.axis, u);
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
    for (const auto& p : points.points) {
      const vec3 d = p - shape.point;
      const double along = dot(d, shape.axis);
      const vec3 off = d - along * shape.axis;
      const double rho = norm(off);
      if (!(rho > 0))
        return;
      const vec3 radial = off / rho;
      const double t = along / points.size;
      Eigen::Matrix<double, 5, 1> row;
      row << -dot(radial, u), -dot(radial, w), -t * dot(radial, u), -t * dot(radial, w), -1;
      normal += row * row.transpose();
      right -= row * (rho - shape.radius);
    }
    const Eigen::Matrix<double, 5, 1> x = normal.ldlt().solve(right);
    if (!x.allFinite())
      return;
    shape.point += x[0] * u + x[1] * w;
    shape.axis = normalized(shape.axis + (x[2] * u + x[3] * w) / points.size);
    shape.radius += x[4];
    if (x.norm() <= 1e-14 * points.size)
      return;
  }
}

std::optional<wall_shape> fit_cylinder(const mesh_version& mesh, std::span<const facet_id> facets,
                                       const cloud& points) {
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
  refine(points, shape);
  double outward = 0;
  for (const auto f : facets) {
    const auto& v = mesh.facet(f).v;
    const vec3 middle = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
    const vec3 area = area_vector(mesh, mesh.facet(f));
    outward += dot(area, shape.normal(middle));
    // The corners of a square boss lie on a cylinder, too.
    for (int i = 0; i < 3; ++i)
      if (dot(shape.normal(mesh.position(v[i])), shape.normal(mesh.position(v[(i + 1) % 3]))) <
            widest_facet ||
          std::abs(dot(area, shape.axis)) > steepest * norm(area))
        return std::nullopt;
  }
  shape.side = outward > 0 ? 1 : -1;
  for (const auto& p : points.points)
    if (!(std::abs(shape.distance(p)) <= roundness * shape.radius))
      return std::nullopt;
  return shape;
}

}  // namespace

double wall_shape::distance(vec3 p) const {
  const vec3 d = p - point;
  if (type == kind::plane)
    return dot(axis, d);
  return side * (norm(d - dot(d, axis) * axis) - radius);
}

vec3 wall_shape::normal(vec3 p) const {
  if (type == kind::plane)
    return axis;
  const vec3 d = p - point;
  return side * normalized(d - dot(d, axis) * axis);
}

std::optional<wall_shape> fit_wall(const mesh_version& mesh, std::span<const facet_id> facets) {
  if (facets.empty())
    return std::nullopt;
  const auto points = gather(mesh, facets);
  if (auto plane = fit_plane(points))
    return plane;
  return fit_cylinder(mesh, facets, points);
}

vec3 rolling_ball::along(vec3 p) const {
  return normalized(cross(a_.normal(p), b_.normal(p)));
}

std::optional<vec3> rolling_ball::centre(vec3 p) const {
  const vec3 na = a_.normal(p);
  const vec3 nb = b_.normal(p);
  const vec3 t = along(p);
  const vec3 start = p + (side_ * radius_ / (1 + dot(na, nb))) * (na + nb);
  const double reach = 4 * norm(start - p) + radius_;
  const auto system = [&](vec3 c) {
    return std::array<equation, 3>{{{a_.distance(c) - side_ * radius_, a_.normal(c)},
                                    {b_.distance(c) - side_ * radius_, b_.normal(c)},
                                    {dot(t, c - p), t}}};
  };
  const auto found = solve(system, start, reach);
  // Beyond the axis of a cylinder the distance has another branch: the contacts tell.
  if (!found || dot(a_.normal(*found), na) < 0 || dot(b_.normal(*found), nb) < 0)
    return std::nullopt;
  return found;
}

std::optional<vec3> rolling_ball::centre_where(double share,
                                               const std::function<double(vec3)>& condition,
                                               vec3 start) const {
  return centre_at([&](vec3 c) { return condition(on_arc(c, share)); }, start, 10 * radius_);
}

/// The centre at which a function vanishes; its slope is taken by differences.
std::optional<vec3> rolling_ball::centre_at(const std::function<double(vec3)>& value, vec3 start,
                                            double reach) const {
  const double step = 1e-6 * radius_;
  const auto system = [&](vec3 c) {
    const auto slope = [&](vec3 d) { return (value(c + d) - value(c - d)) / (2 * step); };
    return std::array<equation, 3>{
      {{a_.distance(c) - side_ * radius_, a_.normal(c)},
       {b_.distance(c) - side_ * radius_, b_.normal(c)},
       {value(c), {slope({step, 0, 0}), slope({0, step, 0}), slope({0, 0, step})}}}};
  };
  return solve(system, start, reach);
}

double rolling_ball::arc(vec3 centre) const {
  const vec3 ea = a_.normal(centre);
  const vec3 eb = b_.normal(centre);
  return std::atan2(norm(cross(ea, eb)), dot(ea, eb));
}

vec3 rolling_ball::on_arc(vec3 centre, double share) const {
  const vec3 ea = -side_ * a_.normal(centre);
  const vec3 eb = -side_ * b_.normal(centre);
  const double angle = arc(centre);
  return centre + (radius_ / std::sin(angle)) *
                    (std::sin((1 - share) * angle) * ea + std::sin(share * angle) * eb);
}

std::optional<double> rolling_ball::distance(vec3 p, vec3 start) const {
  const auto c = centre_at([&](vec3 at) { return dot(along(at), at - p); }, start,
                           10 * radius_ + 2 * norm(p - start));
  if (!c)
    return std::nullopt;
  return norm(p - *c) - radius_;
}

std::optional<vec3> ball_in_corner(const wall_shape& a, const wall_shape& b, const wall_shape& c,
                                   double radius, double side, vec3 p) {
  const auto system = [&](vec3 x) {
    return std::array<equation, 3>{{{a.distance(x) - side * radius, a.normal(x)},
                                    {b.distance(x) - side * radius, b.normal(x)},
                                    {c.distance(x) - side * radius, c.normal(x)}}};
  };
  return solve(system, p, 20 * radius);
}

}  // namespace tedit::ops
