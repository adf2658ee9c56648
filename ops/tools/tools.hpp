// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes tools for `services::boolean`: closed surfaces with triangles of a given size.
#pragma once

#include "ops/sdk/operation.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

/// A place with three axes: x, y and z are unit and at right angles.
struct frame {
  vec3 origin;
  vec3 x;
  vec3 y;
  vec3 z;

  [[nodiscard]] vec3 at(double a, double b, double c) const {
    return origin + a * x + b * y + c * z;
  }
};

/// A frame with this z; x is as near to `up` x z as can be, or any direction across where `up` is
/// along z or zero: so y is as near to `up` as can be.
[[nodiscard]] frame make_frame(vec3 origin, vec3 z, vec3 up = {});

/// A closed outline in the plane of x and y, m. Edge i goes from point i to the next one.
struct outline {
  std::vector<std::array<double, 2>> points;
  std::vector<std::uint32_t> side;  ///< Of each edge: an index of `profile::sides`.
};

/// What is extruded: outlines, even-odd filled, and the names of the walls along them.
struct profile {
  std::vector<outline> outlines;
  std::vector<std::string> sides;
};

/// One outline each, around the origin. A circle has `segments` edges and one wall, a slot straight
/// and round ones, a polygon a wall an edge.
[[nodiscard]] profile circle(double diameter, int segments);
[[nodiscard]] profile rectangle(double width, double height);
[[nodiscard]] profile slot(double length, double width, int segments);
[[nodiscard]] profile polygon(const std::vector<std::array<double, 2>>& points);

/// How many edges a circle has whose edges measure about `size`: 16 at least.
[[nodiscard]] int segments_of(double diameter, double size);

/// The profile from z = `from` to `to`, with triangles of about `size`. The ends are named
/// "`name` bottom" and "`name` top". Errors: `mesher_failed` where outlines cross.
[[nodiscard]] expected<tool_surface> extrude(const frame& place, const profile& what, double from,
                                             double to, double size, const std::string& name,
                                             services& host);

/// A point of the half-section of what turns round the z axis.
struct section_point {
  double radius = 0;  ///< m.
  double height = 0;  ///< m.
  std::string wall;   ///< Of the part of the section that ends here; unused for the first point.
};

/// The section turned round the axis; its first and last points have radius 0, and it goes from top
/// to bottom with the material on the axis' side. Walls of the same name are one face.
[[nodiscard]] tool_surface revolve(const frame& place, const std::vector<section_point>& section,
                                   int segments, double size);

/// A box around `extent`, on the side of the plane that `normal` points away from. The face in the
/// plane is "`name`". Errors: those of `extrude`.
[[nodiscard]] expected<tool_surface> half_space(const box& extent, vec3 point, vec3 normal,
                                                double size, const std::string& name,
                                                services& host);

}  // namespace tedit::ops
