// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "mesh/features/exact_wall.hpp"

namespace tedit::ops {

/// A flat picture of a piece of a wall, counter-clockwise seen from outside: a plane as it is, a
/// sphere by stereographic projection from the point opposite to the piece, what turns about an
/// axis unrolled: the angle about it across, the length along its section up. A piece that goes all
/// around the axis (or a torus' tube) spreads out as a ring, by the map
/// (angle, length) -> e^(length / R) (cos angle, sin angle), which keeps a cylinder's angles.
class wall_map {
public:
  /// @param facets the piece. Cost: O(piece).
  wall_map(const mesh_version& mesh, const exact_wall& wall, std::span<const facet_id> facets);

  [[nodiscard]] std::array<double, 2> flatten(vec3 p) const;

  /// Back onto the exact wall.
  [[nodiscard]] vec3 lift(std::array<double, 2> p) const;

private:
  /// A place on what turns about an axis.
  struct turned {
    double angle = 0;   ///< About the axis, rad; about a torus' tube from its widest circle on.
    double length = 0;  ///< m; along the section, or about the axis where the tube is a ring.
  };

  void find_cuts(const mesh_version& mesh, std::span<const facet_id> facets);
  [[nodiscard]] turned place_of(vec3 p) const;
  [[nodiscard]] vec3 point_at(turned at) const;
  [[nodiscard]] double about_axis(vec3 p) const;
  [[nodiscard]] double about_tube(vec3 p) const;
  [[nodiscard]] vec3 radial(double angle) const;

  exact_wall wall_;
  vec3 origin_;
  vec3 u_, w_, axis_;
  double radius_ = 0;  ///< m: of the ring, and what makes lengths of angles.
  double start_ = 0;   ///< Angles at which an unrolled wall is cut, rad.
  double tube_start_ = 0;
  bool ring_ = false;
  bool tube_is_ring_ = false;
};

}  // namespace tedit::ops
