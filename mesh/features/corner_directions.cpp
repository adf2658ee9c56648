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
/// Corners within so many edges are fitted to, and where these are few, within so many.
constexpr int rings = 2;
constexpr int most_rings = 4;

using neighbour_lists = std::vector<std::vector<std::uint32_t>>;

neighbour_lists neighbours_of(const facet_corners& facets) {
  neighbour_lists result(facets.points.size());
  for (const auto& t : facets.triangles)
    for (int i = 0; i < 3; ++i) {
      result[t[i]].push_back(t[(i + 1) % 3]);
      result[t[i]].push_back(t[(i + 2) % 3]);
    }
  for (auto& list : result) {
    std::ranges::sort(list);
    list.erase(std::ranges::unique(list).begin(), list.end());
  }
  return result;
}

/// Unit: of the facets at each corner, by their areas.
std::vector<vec3> mean_normals(const facet_corners& facets) {
  std::vector<vec3> result(facets.points.size());
  for (const auto& t : facets.triangles) {
    const auto& p = facets.points;
    const vec3 area = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    for (const auto v : t)
      result[v] += area;
  }
  for (auto& n : result)
    n = normalized(n);
  return result;
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

/// Those of triangles of which no corner is on the rim.
std::vector<std::uint8_t> deep_corners(const facet_corners& facets,
                                       const std::vector<std::uint8_t>& on_rim) {
  std::vector<std::uint8_t> result(facets.points.size());
  for (const auto& t : facets.triangles)
    if (std::ranges::none_of(t, [&](auto v) { return on_rim[v] != 0; }))
      for (const auto v : t)
        result[v] = 1;
  return result;
}

/// Fits the direction of one corner after the other.
class direction_fit {
public:
  explicit direction_fit(const facet_corners& facets)
      : facets_(facets),
        neighbours_(neighbours_of(facets)),
        mean_(mean_normals(facets)),
        seen_(facets.points.size(), no_corner),
        on_rim_(rim_corners(facets)),
        is_deep_(deep_corners(facets, on_rim_)) {
    bends_.resize(facets.points.size(), 1);
    for (const auto& t : facets.triangles) {
      const auto& p = facets.points;
      const vec3 n = normalized(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
      for (const auto v : t)
        bends_[v] = std::min(bends_[v], dot(n, mean_[v]));
    }
  }

  [[nodiscard]] const std::vector<vec3>& mean() const { return mean_; }

  std::optional<vec3> operator()(std::uint32_t corner) {
    if (bends_[corner] < least_cosine)
      return std::nullopt;
    gather(corner);
    const vec3 n = mean_[corner];
    const vec3 helper = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    const vec3 u = normalized(cross(helper, n));
    const vec3 w = cross(n, u);
    double scale = 0;
    for (std::size_t i = 0; i < first_ring_; ++i)
      scale += norm(facets_.points[around_[i]] - facets_.points[corner]) /
               static_cast<double>(first_ring_);
    rows_.clear();
    for (const auto v : around_) {
      const vec3 d = (facets_.points[v] - facets_.points[corner]) / scale;
      rows_.push_back({dot(d, u), dot(d, w), dot(d, n)});
    }
    if (!has_rows(corner))
      return std::nullopt;
    auto slope = fit<cubic_terms>();
    if (!slope)
      slope = fit<square_terms>();
    if (!slope)
      return std::nullopt;
    return normalized(n - (*slope)[0] * u - (*slope)[1] * w);
  }

private:
  static constexpr std::uint32_t no_corner = ~std::uint32_t{0};

  /// The corners within two edges, more where these are few; those of one edge first.
  void gather(std::uint32_t corner) {
    around_.clear();
    around_.push_back(corner);
    seen_[corner] = corner;
    std::size_t begin = 0;
    for (int ring = 0; ring < rings + on_rim_[corner] || (ring < most_rings && is_few()); ++ring) {
      const std::size_t end = around_.size();
      for (std::size_t i = begin; i < end; ++i)
        for (const auto v : neighbours_[around_[i]])
          if (seen_[v] != corner) {
            seen_[v] = corner;
            around_.push_back(v);
          }
      if (ring == 0)
        first_ring_ = around_.size() - 1;
      begin = end;
    }
    around_.erase(around_.begin());
  }

  [[nodiscard]] bool is_few() const { return around_.size() <= square_terms + enough_more; }

  template <int Terms>
  static Eigen::Matrix<double, Terms, 1> terms_at(double x, double y) {
    Eigen::Matrix<double, Terms, 1> t;
    if constexpr (Terms == square_terms)
      t << x, y, x * x, x * y, y * y;
    else
      t << x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
    return t;
  }

  /// Four rows of corners, whichever way: three lie on a parabola whatever they are a part of, two
  /// flat strips, too.
  [[nodiscard]] bool has_rows(std::uint32_t corner) const {
    return is_deep_[corner] != 0 ||
           std::ranges::any_of(around_, [&](std::uint32_t v) { return is_deep_[v] != 0; });
  }

  /// The slopes of the height over the tangent plane; nothing where the corners around do not say
  /// them, or something else than a smooth surface.
  template <int Terms>
  [[nodiscard]] std::optional<std::array<double, 2>> fit() const {
    if (rows_.size() < Terms + enough_more)
      return std::nullopt;
    Eigen::Matrix<double, Terms, Terms> normal = Eigen::Matrix<double, Terms, Terms>::Zero();
    Eigen::Matrix<double, Terms, 1> right = Eigen::Matrix<double, Terms, 1>::Zero();
    for (const auto& [x, y, z] : rows_) {
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
    if (!leaves_little<Terms>(x))
      return std::nullopt;
    return std::array{x[0], x[1]};
  }

  static double weight_of(double x, double y) {
    const double d = x * x + y * y;
    return 1 / (0.1 + d * d);
  }

  /// Beside what a plane through the corner leaves.
  template <int Terms>
  [[nodiscard]] bool leaves_little(const Eigen::Matrix<double, Terms, 1>& solution) const {
    double left = 0;
    double flat = 0;
    for (const auto& [x, y, z] : rows_) {
      const double weight = weight_of(x, y);
      const double off = z - terms_at<Terms>(x, y).dot(solution);
      const double bend = z - x * solution[0] - y * solution[1];
      left += weight * off * off;
      flat += weight * bend * bend;
    }
    const auto more = static_cast<double>(rows_.size()) / static_cast<double>(rows_.size() - Terms);
    return left * more <= fitted_share * fitted_share * flat || left <= flat_share * flat_share;
  }

  const facet_corners& facets_;
  neighbour_lists neighbours_;
  std::vector<vec3> mean_;
  std::vector<double> bends_;
  std::vector<std::uint32_t> seen_;
  std::vector<std::uint8_t> on_rim_;
  std::vector<std::uint8_t> is_deep_;
  std::vector<std::uint32_t> around_;
  std::size_t first_ring_ = 0;
  std::vector<std::array<double, 3>> rows_;
};

}  // namespace

corner_directions directions_at_corners(const facet_corners& facets) {
  direction_fit fit(facets);
  corner_directions result{{}, fit.mean()};
  for (std::uint32_t v = 0; v < facets.points.size(); ++v)
    result.said.push_back(fit(v));
  return result;
}

}  // namespace tedit
