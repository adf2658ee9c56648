// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/corner_directions.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mesh/segment/facet_net.hpp"

namespace tedit {

namespace {

/// A corner's facets may turn so far from its direction: cosine of 35 degrees.
constexpr double least_cosine = 0.82;
/// What the fit leaves of what a plane would: more is a crease, or noise.
constexpr double fitted_share = 0.25;
/// Of the edges' length: what is off a plane by less is on it.
constexpr double flat_share = 1e-7;
/// Corners around that are needed, more than there are unknowns.
constexpr int enough_more = 3;
constexpr int square_terms = 5;
constexpr int cubic_terms = 9;
constexpr double least_pivot = 1e-7;
/// Corners within so many edges are fitted to, one more at the rim; where these are few, within so
/// many.
constexpr int rings = 2;
constexpr int most_rings = 4;

/// Corners around one, in its tangent plane and over it, by the length of its edges.
using nearby = std::vector<std::array<double, 3>>;

double weight_of(double x, double y) {
  const double d = x * x + y * y;
  return 1 / (0.1 + d * d);
}

template <int Terms>
Eigen::Matrix<double, Terms, 1> terms_at(double x, double y) {
  Eigen::Matrix<double, Terms, 1> t;
  if constexpr (Terms == square_terms)
    t << x, y, x * x, x * y, y * y;
  else
    t << x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return t;
}

/// Beside what a plane through the corner leaves.
template <int Terms>
bool leaves_little(const nearby& rows, const Eigen::Matrix<double, Terms, 1>& solution) {
  double left = 0;
  double flat = 0;
  for (const auto& [x, y, z] : rows) {
    const double weight = weight_of(x, y);
    const double off = z - terms_at<Terms>(x, y).dot(solution);
    const double bend = z - x * solution[0] - y * solution[1];
    left += weight * off * off;
    flat += weight * bend * bend;
  }
  const auto more = static_cast<double>(rows.size()) / static_cast<double>(rows.size() - Terms);
  return left * more <= fitted_share * fitted_share * flat || left <= flat_share * flat_share;
}

/// The slopes of the height; nothing where the corners around do not say them, or something else
/// than a smooth surface.
template <int Terms>
std::optional<std::array<double, 2>> fit(const nearby& rows) {
  if (rows.size() < Terms + enough_more)
    return std::nullopt;
  Eigen::Matrix<double, Terms, Terms> normal = Eigen::Matrix<double, Terms, Terms>::Zero();
  Eigen::Matrix<double, Terms, 1> right = Eigen::Matrix<double, Terms, 1>::Zero();
  for (const auto& [x, y, z] : rows) {
    const auto t = terms_at<Terms>(x, y);
    const double weight = weight_of(x, y);
    normal += weight * t * t.transpose();
    right += weight * z * t;
  }
  auto solved = normal.fullPivLu();
  solved.setThreshold(least_pivot);
  if (solved.rank() < Terms)
    return std::nullopt;
  const Eigen::Matrix<double, Terms, 1> x = solved.solve(right);
  if (!leaves_little<Terms>(rows, x))
    return std::nullopt;
  return std::array{x[0], x[1]};
}

std::vector<std::uint8_t> rim_corners(const facet_corners& facets) {
  std::vector<std::uint8_t> on_rim(facets.points.size());
  const auto across = triangles_across(facets.triangles);
  for (std::size_t i = 0; i < across.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (across[i][k] == no_id)
        on_rim[facets.triangles[i][k]] = on_rim[facets.triangles[i][(k + 1) % 3]] = 1;
  return on_rim;
}

}  // namespace

corner_directions::corner_directions(const facet_corners& facets)
    : facets_(facets),
      first_(facets.points.size() + 1),
      neighbours_(6 * facets.triangles.size()),
      mean_(facets.points.size()),
      bends_(facets.points.size(), 1),
      on_rim_(rim_corners(facets)),
      is_deep_(facets.points.size()),
      is_found_(facets.points.size()),
      found_(facets.points.size()) {
  const auto& p = facets.points;
  const auto area = [&](const auto& t) { return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]); };
  for (const auto& t : facets.triangles)
    for (const auto v : t) {
      first_[v + 1] += 2;
      mean_[v] += area(t);
    }
  for (std::size_t v = 0; v < p.size(); ++v) {
    first_[v + 1] += first_[v];
    mean_[v] = normalized(mean_[v]);
  }
  auto next = first_;
  for (const auto& t : facets.triangles) {
    const vec3 n = normalized(area(t));
    const bool is_deep = std::ranges::none_of(t, [&](auto v) { return is_on_rim(v); });
    for (int i = 0; i < 3; ++i) {
      bends_[t[i]] = std::min(bends_[t[i]], dot(n, mean_[t[i]]));
      is_deep_[t[i]] |= is_deep ? 1 : 0;
      neighbours_[next[t[i]]++] = t[(i + 1) % 3];
      neighbours_[next[t[i]]++] = t[(i + 2) % 3];
    }
  }
}

const std::optional<vec3>& corner_directions::at(std::uint32_t corner) const {
  if (is_found_[corner] == 0) {
    is_found_[corner] = 1;
    found_[corner] = fitted(corner);
  }
  return found_[corner];
}

std::optional<vec3> corner_directions::fitted(std::uint32_t corner) const {
  if (bends_[corner] < least_cosine)
    return std::nullopt;
  const auto near = around(corner);
  if (!has_rows(corner, near))
    return std::nullopt;
  const vec3 n = mean_[corner];
  const vec3 helper = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  const vec3 u = normalized(cross(helper, n));
  const vec3 w = cross(n, u);
  double scale = 0;
  for (auto i = first_[corner]; i < first_[corner + 1]; ++i)
    scale += norm(facets_.points[neighbours_[i]] - facets_.points[corner]) /
             (first_[corner + 1] - first_[corner]);
  nearby rows;
  for (const auto v : near) {
    const vec3 d = (facets_.points[v] - facets_.points[corner]) / scale;
    rows.push_back({dot(d, u), dot(d, w), dot(d, n)});
  }
  auto slope = fit<cubic_terms>(rows);
  if (!slope)
    slope = fit<square_terms>(rows);
  if (!slope)
    return std::nullopt;
  return normalized(n - (*slope)[0] * u - (*slope)[1] * w);
}

/// The corners within two edges, more at the rim and where these are few.
std::vector<std::uint32_t> corner_directions::around(std::uint32_t corner) const {
  std::vector<std::uint32_t> result{corner};
  std::size_t begin = 0;
  const auto is_few = [&] { return result.size() <= square_terms + enough_more; };
  for (int ring = 0; ring < rings + on_rim_[corner] || (ring < most_rings && is_few()); ++ring) {
    const std::size_t end = result.size();
    for (std::size_t i = begin; i < end; ++i)
      for (auto k = first_[result[i]]; k < first_[result[i] + 1]; ++k)
        if (std::ranges::find(result, neighbours_[k]) == result.end())
          result.push_back(neighbours_[k]);
    begin = end;
  }
  result.erase(result.begin());
  return result;
}

/// Four rows of corners, whichever way: three lie on a parabola whatever they are a part of, two
/// flat strips, too.
bool corner_directions::has_rows(std::uint32_t corner,
                                 const std::vector<std::uint32_t>& near) const {
  return is_deep_[corner] != 0 ||
         std::ranges::any_of(near, [&](std::uint32_t v) { return is_deep_[v] != 0; });
}

}  // namespace tedit
