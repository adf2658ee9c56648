// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "base/error.hpp"
#include "mesh/version.hpp"

/// Structured tet meshes of the benchmarks' shapes, made by formula, so that a result can be
/// repeated anywhere without a mesher.
namespace tedit::verification {

/// Where a point (s, t, u) of the unit cube goes, m.
using placement = std::function<vec3(vec3)>;

/// Surface ids of a block.
enum block_side : surface_id {
  s_low = 1,
  s_high = 2,
  t_low = 3,
  t_high = 4,
  u_low = 5,
  u_high = 6
};

/// A unit cube of cells, each cut into Kuhn's six tets (all diagonals run from the lowest to the
/// highest corner, so that neighbours fit), moved by `place`, which may mirror. Errors:
/// `invalid_mesh` when `place` turns tets inside out or flattens them. Cost: O(cells).
[[nodiscard]] expected<version_ptr> block_mesh(std::array<int, 3> cells, const placement& place);

/// Surface ids of an octant of a spherical shell.
enum octant_side : surface_id { inner = 1, outer = 2, x_zero = 3, y_zero = 4, z_zero = 5 };

/// The octant x, y, z >= 0 of a spherical shell: `along` triangles along each quarter circle, and
/// `layers` of prisms of three tets whose thickness grows with the radius. The spheres are faceted
/// with their corners on the sphere. Errors: `invalid_mesh`. Cost: O(along^2 layers).
[[nodiscard]] expected<version_ptr> octant_mesh(int along, int layers, double inner_radius,
                                                double outer_radius);

/// A box [0, size] as a placement.
[[nodiscard]] placement box(vec3 size);

/// A box [0, size] whose inner points are moved by up to 6 % of its smallest side, smoothly, so
/// that no two tets are alike; the boundary stays.
[[nodiscard]] placement shaken_box(vec3 size);

/// Part of an annulus between two ellipses with the half axes (ax, ay) inside and (bx, by) outside:
/// s from inside to outside, t the angle from the x axis to the y axis, u the height from 0.
/// `towards_inside` > 1 makes the cells next to the inside thinner (s to that power), `towards_x`
/// > 1 those next to the x axis.
struct quarter_ring {
  std::array<double, 2> inside{1, 1};
  std::array<double, 2> outside{2, 2};
  double height = 1;
  double towards_inside = 1;
  double towards_x = 1;

  [[nodiscard]] vec3 operator()(vec3 stu) const;
};

/// A quarter of NAFEMS LE11's body, revolved about z: a sphere of radius 1 inside and 1.4 outside
/// up to z = 1/sqrt 2, a taper of 0.69 above it, a cylinder of 0.4 (radii 1/sqrt 2 and 1) on top. s
/// from inside to outside, t from the bottom to the top (its fifths: two sphere, two taper, one
/// cylinder), u the angle from the x axis to the y axis.
[[nodiscard]] vec3 tapered_sphere(vec3 stu);

}  // namespace tedit::verification
