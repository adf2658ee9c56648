// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "mesh/features/exact_wall.hpp"

namespace tedit::ops {

/// A ball of radius r that rolls along the edge between two walls: in the open space (`side` +1,
/// which rounds an inner corner) or inside the material (-1, an outer edge).
class rolling_ball {
public:
  rolling_ball(exact_wall a, exact_wall b, double radius, double side)
      : a_(a), b_(b), radius_(radius), side_(side) {}

  [[nodiscard]] const exact_wall& a() const { return a_; }
  [[nodiscard]] const exact_wall& b() const { return b_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double side() const { return side_; }

  /// The ball's centre where it touches both walls, in the plane through p across the edge; nothing
  /// where the ball does not fit (Newton's method, to rounding).
  [[nodiscard]] std::optional<vec3> centre(vec3 p) const;

  /// The centre at which the arc's point at `share` fulfils condition(point) = 0: where the
  /// rounding ends at another surface. Searched from `start`, a centre.
  [[nodiscard]] std::optional<vec3> centre_where(double share,
                                                 const std::function<double(vec3)>& condition,
                                                 vec3 start) const;

  /// The point of the arc between the two contacts, share 0 at wall a, 1 at wall b: exactly at
  /// distance r from the centre.
  [[nodiscard]] vec3 on_arc(vec3 centre, double share) const;

  /// The angle of the arc, rad.
  [[nodiscard]] double arc(vec3 centre) const;

  /// Direction of the edge, unit: along a x b of the outward normals.
  [[nodiscard]] vec3 along(vec3 p) const;

  /// Signed distance of a point from the swept ball's surface, m: positive outside the ball.
  /// Nothing far from the centres near `start`.
  [[nodiscard]] std::optional<double> distance(vec3 p, vec3 start) const;

private:
  [[nodiscard]] std::optional<vec3> centre_at(const std::function<double(vec3)>& value, vec3 start,
                                              double reach) const;

  exact_wall a_, b_;
  double radius_;
  double side_;
};

/// The centre of the ball that touches three walls from `side`; nothing where there is none near p.
[[nodiscard]] std::optional<vec3> ball_in_corner(const exact_wall& a, const exact_wall& b,
                                                 const exact_wall& c, double radius, double side,
                                                 vec3 p);

}  // namespace tedit::ops
