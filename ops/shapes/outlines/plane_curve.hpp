// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "ops/shapes/outlines/plane.hpp"

namespace tedit::ops {

struct line_curve {
  point2 from;
  point2 to;
};

/// centre + u cos t + v sin t, for t from `from` to `to` (rad): of a circle or an ellipse, either
/// way round.
struct arc_curve {
  point2 centre;
  point2 u;
  point2 v;
  double from = 0;
  double to = 0;
};

/// A NURBS curve over the knots from number `degree` to number `poles.size()`: as many knots as
/// poles, degree and one together, ascending, and that interval not empty.
struct spline_curve {
  int degree = 1;
  std::vector<double> knots;
  std::vector<std::array<double, 3>> poles;  ///< x w, y w, w: the weight w is positive.
};

using plane_curve = std::variant<line_curve, arc_curve, spline_curve>;

[[nodiscard]] plane_curve moved(const plane_curve& curve, const affine& how);
[[nodiscard]] plane_curve reversed(const plane_curve& curve);

/// Where it is after this share of its parameter, 0 to 1.
[[nodiscard]] point2 point_of(const plane_curve& curve, double share);

/// What turns by more than this between two corners gets one between: 24 for a circle.
inline constexpr double most_turn = 0.2617993877991494;  // rad, 15 degrees

/// Appends corners on the curve, the first point left out: edges of at most about `edge`, none of
/// which turns by more than `most_turn`; a line is one edge. Stops where there are more than `most`
/// of them all together.
void append_corners(const plane_curve& curve, double edge, std::size_t most,
                    std::vector<point2>& corners);

/// The least box that has the curve; of a spline the one of its poles.
struct plane_box {
  point2 low{1e300, 1e300};
  point2 high{-1e300, -1e300};

  void add(point2 p);
  [[nodiscard]] double longer_side() const;
  [[nodiscard]] point2 middle() const;
};
void add_to(plane_box& box, const plane_curve& curve);

}  // namespace tedit::ops
