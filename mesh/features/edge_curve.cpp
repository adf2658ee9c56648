// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/edge_curve.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "mesh/features/rims.hpp"

namespace tedit {

namespace {

constexpr double straightness = 1e-4;  ///< Share of the length.
constexpr double arc_roundness = 1e-2;
constexpr double least_arc = 80 * std::numbers::pi / 180;
constexpr double sharpest_turn = 0.2588;  ///< Cosine of 75 degrees.

using vertex_links = std::map<vertex_id, std::set<vertex_id>>;

vertex_links common_edges(const mesh_version& mesh, surface_id first, surface_id second) {
  vertex_links links;
  for (const auto f : facets_of(mesh, std::array{first}))
    for (int i = 0; i < 3; ++i)
      if (mesh.facet(facet_across(mesh, f, i)).surface == second) {
        const auto& v = mesh.facet(f).v;
        links[v[i]].insert(v[(i + 1) % 3]);
        links[v[(i + 1) % 3]].insert(v[i]);
      }
  return links;
}

/// Takes the row that begins with this edge out of the links.
std::vector<vertex_id> take_row(vertex_links& links, const vertex_links& all, vertex_id from,
                                vertex_id to) {
  std::vector<vertex_id> row{from};
  while (true) {
    links.at(row.back()).erase(to);
    links.at(to).erase(row.back());
    row.push_back(to);
    if (all.at(to).size() != 2 || links.at(to).empty())
      return row;
    to = *links.at(to).begin();
  }
}

std::vector<std::vector<vertex_id>> rows_of(const vertex_links& all) {
  std::vector<std::vector<vertex_id>> rows;
  auto links = all;
  for (const bool ends : {true, false})
    for (const auto& [v, others] : all)
      while ((!ends || others.size() != 2) && !links.at(v).empty())
        rows.push_back(take_row(links, all, v, *links.at(v).begin()));
  return rows;
}

vec3 along_half(const edge_curve& curve) {
  double left = curve.length / 2;
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    const vec3 step = curve.points[(i + 1) % n] - curve.points[i];
    if (norm(step) >= left)
      return curve.points[i] + left * normalized(step);
    left -= norm(step);
  }
  return curve.points.back();
}

bool is_straight(const edge_curve& curve) {
  const vec3 way = curve.points.back() - curve.points.front();
  const vec3 unit = normalized(way);
  return !curve.closed && norm(way) > 0 && std::ranges::all_of(curve.points, [&](vec3 p) {
    const vec3 d = p - curve.points.front();
    return norm(d - dot(d, unit) * unit) <= straightness * norm(way);
  });
}

/// Across the plane through the points nearest to all.
vec3 plane_normal(const std::vector<vec3>& points, vec3 centre) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d d(p.x - centre.x, p.y - centre.y, p.z - centre.z);
    spread += d * d.transpose();
  }
  const Eigen::Vector3d n =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return normalized({n[0], n[1], n[2]});
}

/// The circle through points around an origin, in the plane across `normal`, by least squares.
std::optional<vec3> circle_centre(const std::vector<vec3>& points, vec3 origin, vec3 normal,
                                  double& radius) {
  const vec3 x =
    normalized(points.front() - origin - dot(points.front() - origin, normal) * normal);
  const vec3 y = cross(normal, x);
  Eigen::MatrixXd rows(points.size(), 3);
  Eigen::VectorXd right(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vec3 d = points[i] - origin;
    const auto k = static_cast<Eigen::Index>(i);
    rows.row(k) << 2 * dot(d, x), 2 * dot(d, y), 1;
    right[k] = dot(d, x) * dot(d, x) + dot(d, y) * dot(d, y);
  }
  const Eigen::Vector3d c = rows.colPivHouseholderQr().solve(right);
  radius = std::sqrt(c[2] + c[0] * c[0] + c[1] * c[1]);
  if (!(radius > 0) || !std::isfinite(radius))
    return std::nullopt;
  return origin + c[0] * x + c[1] * y;
}

/// Goes on smoothly enough to be a circle, and far enough round.
bool bends_as_an_arc(const edge_curve& curve) {
  const std::size_t n = curve.points.size();
  for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
    const vec3 in = normalized(curve.points[i] - curve.points[(i + n - 1) % n]);
    const vec3 out = normalized(curve.points[(i + 1) % n] - curve.points[i]);
    if (dot(in, out) < sharpest_turn)
      return false;
  }
  return curve.closed || curve.length >= least_arc * curve.radius * (1 - arc_roundness);
}

void fit_arc(edge_curve& curve) {
  if (curve.points.size() < 4)
    return;
  vec3 centre;
  for (const auto& p : curve.points)
    centre += p / static_cast<double>(curve.points.size());
  const vec3 normal = plane_normal(curve.points, centre);
  edge_curve arc = curve;
  const auto middle = circle_centre(curve.points, centre, normal, arc.radius);
  const bool round = middle && std::ranges::all_of(curve.points, [&](vec3 p) {
                       const double height = dot(p - *middle, normal);
                       const double off = norm(p - *middle - height * normal) - arc.radius;
                       return std::hypot(height, off) <= arc_roundness * arc.radius;
                     });
  if (!round || !bends_as_an_arc(arc))
    return;
  curve = arc;
  curve.type = edge_curve::kind::arc;
  curve.middle = *middle;
  curve.direction = upright(normal);
}

edge_curve curve_of(const mesh_version& mesh, const std::vector<vertex_id>& row) {
  edge_curve curve;
  curve.closed = row.front() == row.back();
  for (std::size_t i = 0; i + (curve.closed ? 1 : 0) < row.size(); ++i)
    curve.points.push_back(mesh.position(row[i]));
  for (std::size_t i = 1; i < row.size(); ++i)
    curve.length += norm(mesh.position(row[i]) - mesh.position(row[i - 1]));
  curve.middle = along_half(curve);
  if (is_straight(curve)) {
    curve.type = edge_curve::kind::straight;
    curve.direction = upright(normalized(curve.points.back() - curve.points.front()));
  } else {
    fit_arc(curve);
  }
  return curve;
}

}  // namespace

std::vector<edge_curve> edges_between(const mesh_version& mesh, surface_id first,
                                      surface_id second) {
  std::vector<edge_curve> curves;
  for (const auto& row : rows_of(common_edges(mesh, first, second)))
    curves.push_back(curve_of(mesh, row));
  return curves;
}

vec3 upright(vec3 unit) {
  const double largest = std::max({std::abs(unit.x), std::abs(unit.y), std::abs(unit.z)});
  for (const double x : {unit.x, unit.y, unit.z})
    if (std::abs(x) >= largest * (1 - 1e-9))
      return x < 0 ? -unit : unit;
  return unit;
}

}  // namespace tedit
