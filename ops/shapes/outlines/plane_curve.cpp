// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/plane_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::ops {

namespace {

point2 on_arc(const arc_curve& arc, double t) {
  const double c = std::cos(t);
  const double s = std::sin(t);
  return {arc.centre[0] + c * arc.u[0] + s * arc.v[0], arc.centre[1] + c * arc.u[1] + s * arc.v[1]};
}

/// De Boor's algorithm. Source: Piegl and Tiller, The NURBS Book, 2nd edition, 4.1.
point2 on_spline(const spline_curve& s, double t) {
  const auto degree = static_cast<std::size_t>(s.degree);
  // The last of these knots that is no greater, so that the interval after it is not empty.
  const auto first = s.knots.begin() + s.degree;
  const auto last = s.knots.begin() + static_cast<std::ptrdiff_t>(s.poles.size());
  auto at = std::upper_bound(first, last, t);
  at = at == first ? std::upper_bound(first, last, *first) - 1 : at - 1;
  const auto k = static_cast<std::size_t>(at - s.knots.begin());
  std::vector<std::array<double, 3>> d(s.poles.begin() + static_cast<std::ptrdiff_t>(k - degree),
                                       s.poles.begin() + static_cast<std::ptrdiff_t>(k + 1));
  for (std::size_t r = 1; r <= degree; ++r)
    for (std::size_t j = degree; j >= r; --j) {
      const double low = s.knots[j + k - degree];
      const double width = s.knots[j + 1 + k - r] - low;
      const double share = width > 0 ? (t - low) / width : 0;
      for (int axis = 0; axis < 3; ++axis)
        d[j][axis] = (1 - share) * d[j - 1][axis] + share * d[j][axis];
    }
  return {d[degree][0] / d[degree][2], d[degree][1] / d[degree][2]};
}

double first_of(const spline_curve& s) {
  return s.knots[static_cast<std::size_t>(s.degree)];
}

double last_of(const spline_curve& s) {
  return s.knots[s.poles.size()];
}

/// Halves what is too long or turns too far.
class spline_sampler {
public:
  spline_sampler(const spline_curve& s, double edge, std::size_t most, std::vector<point2>& into)
      : curve_(s), edge_(edge), most_(most), into_(into) {}

  void run() {
    point2 from = on_spline(curve_, first_of(curve_));
    // A span may have as many bends as its degree, so its middle alone tells nothing.
    for (auto k = static_cast<std::size_t>(curve_.degree); k < curve_.poles.size(); ++k) {
      const double low = curve_.knots[k];
      const double high = curve_.knots[k + 1];
      for (int i = 0; i < curve_.degree && high > low; ++i) {
        const double a = low + (high - low) * i / curve_.degree;
        const double b =
          i + 1 == curve_.degree ? high : low + (high - low) * (i + 1) / curve_.degree;
        const point2 to = on_spline(curve_, b);
        add(a, from, b, to, 0);
        from = to;
        if (into_.size() > most_)
          return;
      }
    }
  }

private:
  static constexpr int most_halvings = 16;

  void add(double a, point2 from, double b, point2 to, int depth) {
    const double m = 0.5 * (a + b);
    const point2 middle = on_spline(curve_, m);
    // The arc turns by about twice what its two chords turn by.
    const double turn = std::abs(std::atan2(
      turn_of(from, middle, to),
      (middle[0] - from[0]) * (to[0] - middle[0]) + (middle[1] - from[1]) * (to[1] - middle[1])));
    const bool fine = gap_of(from, middle) + gap_of(middle, to) <= edge_ && 2 * turn <= most_turn;
    if (fine || depth == most_halvings || m <= a || m >= b || into_.size() > most_) {
      into_.push_back(to);
      return;
    }
    add(a, from, m, middle, depth + 1);
    add(m, middle, b, to, depth + 1);
  }

  const spline_curve& curve_;
  double edge_;
  std::size_t most_;
  std::vector<point2>& into_;
};

void append_arc(const arc_curve& arc, double edge, std::size_t most, std::vector<point2>& corners) {
  const double angle = std::abs(arc.to - arc.from);
  const double radius = std::max(gap_of(arc.u, {}), gap_of(arc.v, {}));
  // A whole circle's angle may be a rounding more than it is.
  const double wanted = std::max(angle / most_turn - 1e-9, angle * radius / edge);
  const auto n =
    static_cast<int>(std::ceil(std::clamp(wanted, 1.0, static_cast<double>(most) + 1)));
  for (int i = 1; i <= n && corners.size() <= most; ++i)
    corners.push_back(on_arc(arc, arc.from + (arc.to - arc.from) * i / n));
}

}  // namespace

plane_curve moved(const plane_curve& curve, const affine& how) {
  if (const auto* line = std::get_if<line_curve>(&curve))
    return line_curve{how(line->from), how(line->to)};
  if (const auto* arc = std::get_if<arc_curve>(&curve))
    return arc_curve{how(arc->centre), how.of_way(arc->u), how.of_way(arc->v), arc->from, arc->to};
  auto spline = std::get<spline_curve>(curve);
  for (auto& [x, y, w] : spline.poles) {
    const auto p = how({x / w, y / w});
    x = p[0] * w;
    y = p[1] * w;
  }
  return spline;
}

plane_curve reversed(const plane_curve& curve) {
  if (const auto* line = std::get_if<line_curve>(&curve))
    return line_curve{line->to, line->from};
  if (const auto* arc = std::get_if<arc_curve>(&curve))
    return arc_curve{arc->centre, arc->u, arc->v, arc->to, arc->from};
  auto spline = std::get<spline_curve>(curve);
  const double sum = spline.knots.front() + spline.knots.back();
  std::ranges::reverse(spline.poles);
  std::ranges::reverse(spline.knots);
  for (auto& knot : spline.knots)
    knot = sum - knot;
  return spline;
}

point2 point_of(const plane_curve& curve, double share) {
  if (const auto* line = std::get_if<line_curve>(&curve))
    return {(1 - share) * line->from[0] + share * line->to[0],
            (1 - share) * line->from[1] + share * line->to[1]};
  if (const auto* arc = std::get_if<arc_curve>(&curve))
    return on_arc(*arc, arc->from + share * (arc->to - arc->from));
  const auto& spline = std::get<spline_curve>(curve);
  return on_spline(spline, (1 - share) * first_of(spline) + share * last_of(spline));
}

void append_corners(const plane_curve& curve, double edge, std::size_t most,
                    std::vector<point2>& corners) {
  if (const auto* line = std::get_if<line_curve>(&curve))
    corners.push_back(line->to);
  else if (const auto* arc = std::get_if<arc_curve>(&curve))
    append_arc(*arc, edge, most, corners);
  else
    spline_sampler(std::get<spline_curve>(curve), edge, most, corners).run();
}

void plane_box::add(point2 p) {
  for (int axis = 0; axis < 2; ++axis) {
    low[axis] = std::min(low[axis], p[axis]);
    high[axis] = std::max(high[axis], p[axis]);
  }
}

double plane_box::longer_side() const {
  return std::max(high[0] - low[0], high[1] - low[1]);
}

point2 plane_box::middle() const {
  return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
}

void add_to(plane_box& box, const plane_curve& curve) {
  box.add(point_of(curve, 0));
  box.add(point_of(curve, 1));
  if (const auto* spline = std::get_if<spline_curve>(&curve))
    for (const auto& [x, y, w] : spline->poles)
      box.add({x / w, y / w});
  const auto* arc = std::get_if<arc_curve>(&curve);
  if (!arc)
    return;
  // Where it goes furthest along an axis, each half a turn.
  constexpr double pi = std::numbers::pi;
  const double low = std::min(arc->from, arc->to);
  const double high = std::max(arc->from, arc->to);
  for (int axis = 0; axis < 2; ++axis) {
    const double furthest = std::atan2(arc->v[axis], arc->u[axis]);
    for (double t = furthest + pi * std::ceil((low - furthest) / pi); t <= high; t += pi)
      box.add(on_arc(*arc, t));
  }
}

}  // namespace tedit::ops
