// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/wall_demands.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tedit {

namespace {

/// What is this near to its walls, as a share of their radius, is on them.
constexpr double on_its_wall = 1e-12;
constexpr double rounding = 1e-16;
/// Walls that touch without crossing are as far apart as their fits allow: a place that is nearer
/// to all of them by this factor will do, and one that is as near as this share of the radius.
constexpr double much_nearer = 0.1;
constexpr double touching = 1e-6;
/// A share of the least radius: no chord is so far from its arc.
constexpr double furthest_move = 0.5;
constexpr int most_wall_steps = 40;
/// Directions in which all walls at a vertex change by less than this share are free.
constexpr double least_slope = 1e-3;
/// Facets of one surface that bend by more than this cosine lie in two planes.
constexpr double two_planes = 0.85;
/// Walls that meet at less than 35 degrees run on smoothly.
constexpr double smooth_cosine = 0.82;

double missing(const wall_demand& d, vec3 start, vec3 p) {
  return d.wall ? d.wall->distance(p) : dot(d.normal, p - start);
}

double worst_of(const std::vector<wall_demand>& demands, vec3 start, vec3 p) {
  double worst = 0;
  for (const auto& d : demands)
    worst = std::max(worst, std::abs(missing(d, start, p)));
  return worst;
}

/// The shortest step that fulfils all demands to first order, in the least squares sense where
/// they are more than three.
vec3 step_at(const std::vector<wall_demand>& demands, vec3 start, vec3 p) {
  Eigen::MatrixXd slopes(demands.size(), 3);
  Eigen::VectorXd off(demands.size());
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const vec3 n = demands[i].wall ? demands[i].wall->normal(p) : demands[i].normal;
    slopes.row(row) << n.x, n.y, n.z;
    off[row] = -missing(demands[i], start, p);
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(slopes, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(least_slope);
  const Eigen::Vector3d x = svd.solve(off);
  return {x[0], x[1], x[2]};
}

std::vector<wall_demand> without_smooth(const std::vector<wall_demand>& all, vec3 start) {
  std::vector<wall_demand> result;
  for (const auto& d : all)
    if (!d.free_form || std::ranges::none_of(all, [&](const wall_demand& other) {
          return other.wall && std::abs(dot(other.wall->normal(start), d.normal)) > smooth_cosine;
        }))
      result.push_back(d);
  return result;
}

}  // namespace

wall_place place_on_walls(const std::vector<wall_demand>& all, vec3 start) {
  const auto demands = without_smooth(all, start);
  double radius = 1e300;
  for (const auto& d : demands)
    if (d.wall)
      radius = std::min(radius, d.wall->radius_at(start));
  wall_place result;
  result.at = start;
  result.before = result.after = worst_of(demands, start, start);
  result.found = result.before <= touching * radius;
  const bool there = result.before <= on_its_wall * radius;
  vec3 p = start;
  for (int i = 0; i < most_wall_steps && !there; ++i) {
    const vec3 step = step_at(demands, start, p);
    p += step;
    if (!is_finite(p) || norm(p - start) > furthest_move * radius)
      return result;
    const double off = worst_of(demands, start, p);
    if (off > rounding * radius && norm(step) > rounding * radius && i + 1 < most_wall_steps)
      continue;
    if (off > std::max(on_its_wall * radius, much_nearer * result.before))
      return result;
    result.at = p;
    result.after = off;
    result.found = true;
    return result;
  }
  return result;
}

void add_planes(const std::vector<vec3>& areas, bool free_form, std::vector<wall_demand>& demands) {
  std::vector<vec3> sums;
  for (const auto& area : areas) {
    const auto same = std::ranges::find_if(
      sums, [&](vec3 sum) { return dot(sum, area) > two_planes * norm(sum) * norm(area); });
    if (same == sums.end())
      sums.push_back(area);
    else
      *same += area;
  }
  for (const auto& sum : sums)
    demands.push_back({nullptr, normalized(sum), free_form});
}

}  // namespace tedit
