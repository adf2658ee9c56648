// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/graded_fill.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tedit::ops {

namespace {

using point2 = std::array<double, 2>;

/// Edges may grow by this share of the distance from the loops.
constexpr double growth = 0.5;
/// A triangle is too large beyond this ratio of circumradius and size; 0.58 is equilateral.
constexpr double largest = 0.8;
/// Too thin: circumradius over shortest edge (30 degrees and less at 1).
constexpr double thinnest = 1.2;
/// Points stay this share of the size apart.
constexpr double apart = 0.55;
constexpr std::size_t most_points = 20'000;
constexpr std::uint32_t none = 0xFFFFFFFF;

double cross2(point2 a, point2 b, point2 c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double distance(point2 a, point2 b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double distance_to_segment(point2 p, point2 a, point2 b) {
  const double ux = b[0] - a[0];
  const double uy = b[1] - a[1];
  const double t =
    std::clamp(((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
  return std::hypot(p[0] - a[0] - t * ux, p[1] - a[1] - t * uy);
}

point2 circumcentre(point2 a, point2 b, point2 c) {
  const double bx = b[0] - a[0];
  const double by = b[1] - a[1];
  const double cx = c[0] - a[0];
  const double cy = c[1] - a[1];
  const double d = 2 * (bx * cy - by * cx);
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  return {a[0] + (cy * b2 - by * c2) / d, a[1] + (bx * c2 - cx * b2) / d};
}

class refiner {
public:
  refiner(const planar_polygon& polygon, planar_filling filling)
      : points_(std::move(filling.points)), fixed_(points_.size()) {
    for (const auto& t : filling.triangles)
      triangles_.push_back({t, {none, none, none}, true});
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (int i = 0; i < 3; ++i)
        sides[{triangles_[t].v[i], triangles_[t].v[(i + 1) % 3]}] = t;
    for (auto& t : triangles_)
      for (int i = 0; i < 3; ++i)
        if (const auto other = sides.find({t.v[(i + 1) % 3], t.v[i]}); other != sides.end())
          t.beside[i] = other->second;
    sizes_.assign(points_.size(), 1e300);
    for (const auto& loop : polygon.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto from = loop[i];
        const auto to = loop[(i + 1) % loop.size()];
        const double length = distance(points_[from], points_[to]);
        sizes_[from] = std::min(sizes_[from], length);
        sizes_[to] = std::min(sizes_[to], length);
        loop_sides_.insert(std::minmax(from, to));
      }
  }

  planar_filling refine() {
    for (std::uint32_t t = 0; t < triangles_.size() && points_.size() < fixed_ + most_points; ++t)
      if (triangles_[t].live)
        improve(t);
    for (int round = 0; round < 4; ++round)
      smooth();
    planar_filling result;
    result.points = points_;
    for (const auto& t : triangles_)
      if (t.live)
        result.triangles.push_back(t.v);
    return result;
  }

private:
  struct piece {
    std::array<std::uint32_t, 3> v;
    std::array<std::uint32_t, 3> beside;  ///< Across the edge from v[i] to v[i + 1].
    bool live = true;
  };

  /// How long edges may be at a point, from what they may be at vertices nearby.
  template <class Vertices>
  [[nodiscard]] double size_at(point2 p, const Vertices& around) const {
    double size = 1e300;
    for (const auto v : around)
      size = std::min(size, sizes_[v] + growth * distance(points_[v], p));
    return size;
  }

  /// Inserts the circumcentre of a triangle that is too large or too thin; new triangles come last
  /// in the list and have their turn later.
  void improve(std::uint32_t t) {
    const auto v = triangles_[t].v;
    const auto& a = points_[v[0]];
    const auto& b = points_[v[1]];
    const auto& c = points_[v[2]];
    const point2 centre = circumcentre(a, b, c);
    const double radius = distance(centre, a);
    if (!std::isfinite(radius))
      return;
    const point2 middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
    const double shortest = std::min({distance(a, b), distance(b, c), distance(c, a)});
    if (radius <= largest * size_at(middle, v) && radius <= thinnest * shortest)
      return;
    if (const auto at = locate(t, centre); at != none)
      insert(at, centre);
  }

  /// The triangle that holds a point, by a walk from t; none where a loop lies between.
  [[nodiscard]] std::uint32_t locate(std::uint32_t t, point2 p) const {
    for (std::size_t step = 0; t != none && step < triangles_.size(); ++step) {
      const auto& v = triangles_[t].v;
      int out = -1;
      for (int i = 0; i < 3; ++i)
        if (cross2(points_[v[i]], points_[v[(i + 1) % 3]], p) <= 0)
          out = i;
      if (out < 0)
        return t;
      if (is_loop_side(v[out], v[(out + 1) % 3]))
        return none;
      t = triangles_[t].beside[out];
    }
    return none;
  }

  [[nodiscard]] bool in_circle(const piece& t, point2 p) const {
    const point2 centre = circumcentre(points_[t.v[0]], points_[t.v[1]], points_[t.v[2]]);
    return distance(centre, p) < distance(centre, points_[t.v[0]]);
  }

  /// All triangles whose circle holds the point, and the star that replaces them (Bowyer, Watson);
  /// loop edges bound the hole.
  void insert(std::uint32_t at, point2 p) {
    std::vector<std::uint32_t> hole{at};
    std::set<std::uint32_t> inside{at};
    for (std::size_t next = 0; next < hole.size(); ++next)
      for (int i = 0; i < 3; ++i) {
        const auto& t = triangles_[hole[next]];
        const auto other = t.beside[i];
        if (other == none || inside.contains(other) || is_loop_side(t.v[i], t.v[(i + 1) % 3]) ||
            !in_circle(triangles_[other], p))
          continue;
        inside.insert(other);
        hole.push_back(other);
      }
    struct side {
      std::uint32_t from, to, beyond;
    };
    std::vector<side> rim;
    for (const auto t : hole)
      for (int i = 0; i < 3; ++i) {
        const auto& gone = triangles_[t];
        if (gone.beside[i] == none || !inside.contains(gone.beside[i]))
          rim.push_back({gone.v[i], gone.v[(i + 1) % 3], gone.beside[i]});
      }
    std::vector<std::uint32_t> corners;
    for (const auto& s : rim)
      corners.push_back(s.from);
    const double size = size_at(p, corners);
    for (const auto& s : rim) {
      const auto& a = points_[s.from];
      const auto& b = points_[s.to];
      if (cross2(a, b, p) <= 0 || distance(a, p) < apart * size ||
          (is_loop_side(s.from, s.to) &&
           distance_to_segment(p, a, b) < 0.5 * std::min(size, distance(a, b))))
        return;
    }
    const auto fresh = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    sizes_.push_back(size);
    for (const auto t : hole)
      triangles_[t].live = false;
    std::map<std::uint32_t, std::uint32_t> starting;
    const auto first = static_cast<std::uint32_t>(triangles_.size());
    for (const auto& s : rim) {
      const auto id = static_cast<std::uint32_t>(triangles_.size());
      starting[s.from] = id;
      triangles_.push_back({{s.from, s.to, fresh}, {s.beyond, none, none}, true});
      if (s.beyond != none)
        for (int i = 0; i < 3; ++i)
          if (triangles_[s.beyond].v[i] == s.to)
            triangles_[s.beyond].beside[i] = id;
    }
    for (auto id = first; id < triangles_.size(); ++id) {
      const auto ahead = starting.at(triangles_[id].v[1]);
      triangles_[id].beside[1] = ahead;
      triangles_[ahead].beside[2] = id;
    }
  }

  [[nodiscard]] bool is_loop_side(std::uint32_t a, std::uint32_t b) const {
    return loop_sides_.contains(std::minmax(a, b));
  }

  /// Each added point to the mean of its neighbours, where no triangle turns over.
  void smooth() {
    std::vector<std::vector<std::uint32_t>> at(points_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      if (triangles_[t].live)
        for (const auto v : triangles_[t].v)
          at[v].push_back(t);
    for (auto i = static_cast<std::uint32_t>(fixed_); i < points_.size(); ++i) {
      point2 mean{0, 0};
      for (const auto t : at[i])
        for (const auto v : triangles_[t].v)
          if (v != i)
            for (int c = 0; c < 2; ++c)
              mean[c] += points_[v][c] / (2.0 * static_cast<double>(at[i].size()));
      const auto before = points_[i];
      const double worst = thinness(at[i]);
      points_[i] = mean;
      if (thinness(at[i]) < worst)
        points_[i] = before;
    }
  }

  /// Least ratio of area and squared longest edge: 0 or less when one turned over.
  [[nodiscard]] double thinness(const std::vector<std::uint32_t>& star) const {
    double worst = 1;
    for (const auto t : star) {
      const auto& v = triangles_[t].v;
      const double longest =
        std::max({distance(points_[v[0]], points_[v[1]]), distance(points_[v[1]], points_[v[2]]),
                  distance(points_[v[2]], points_[v[0]])});
      worst =
        std::min(worst, cross2(points_[v[0]], points_[v[1]], points_[v[2]]) / (longest * longest));
    }
    return worst;
  }

  std::vector<point2> points_;
  std::size_t fixed_;
  std::vector<double> sizes_;  ///< Edge length wanted at each point.
  std::vector<piece> triangles_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> loop_sides_;
};

}  // namespace

planar_filling graded_fill(const planar_polygon& polygon, planar_filling filling) {
  return refiner(polygon, std::move(filling)).refine();
}

}  // namespace tedit::ops
