// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/surface_tree.hpp"

#include "mesh/distances.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mesh/predicates.hpp"
#include "ops/shapes/rounding/round_cavity.hpp"

namespace tedit::ops {

namespace {

using component = double vec3::*;

/// A ray along an axis. Where it meets an edge or a corner it counts as moved by ever so little
/// across, and by far less along the third axis: then each crossing lies in one triangle.
class axis_ray {
public:
  axis_ray(vec3 from, vec3 along, double length) : from_(from), to_(from) {
    if (std::abs(along.x) >= std::max(std::abs(along.y), std::abs(along.z)))
      std::tie(along_, first_, second_) = std::tuple(&vec3::x, &vec3::y, &vec3::z);
    else if (std::abs(along.y) >= std::abs(along.z))
      std::tie(along_, first_, second_) = std::tuple(&vec3::y, &vec3::z, &vec3::x);
    to_.*along_ += length;
  }

  [[nodiscard]] box extent() const { return box_of(std::array{from_, to_}); }

  /// 1 where the ray goes out through the triangle, -1 where it comes in, else 0.
  [[nodiscard]] int crossing(const std::array<vec3, 3>& t) const {
    const int turn = side(t[0], t[1]);
    if (turn == 0 || side(t[1], t[2]) != turn || side(t[2], t[0]) != turn)
      return 0;
    return turn * orient3d(t[0], t[1], t[2], from_) < 0 ? turn : 0;
  }

private:
  /// On which side the line of the ray passes the edge; 0 only along it.
  [[nodiscard]] int side(vec3 a, vec3 b) const {
    if (const int sign = orient3d(from_, to_, a, b); sign != 0)
      return sign;
    const auto sign = [](double d) { return d > 0 ? 1 : d < 0 ? -1 : 0; };
    const int moved = sign(a.*second_ - b.*second_);
    return moved != 0 ? moved : sign(b.*first_ - a.*first_);
  }

  vec3 from_, to_;
  component along_ = &vec3::z;
  component first_ = &vec3::x;  ///< Right-handed with the next and the ray.
  component second_ = &vec3::y;
};

std::vector<box> boxes_of(const closed_surface& surface) {
  std::vector<box> result;
  result.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles)
    result.push_back(box_of(std::array{surface.points[a], surface.points[b], surface.points[c]}));
  return result;
}

}  // namespace

surface_tree::surface_tree(const closed_surface& surface)
    : surface_(surface), boxes_(boxes_of(surface)) {}

std::array<vec3, 3> surface_tree::corners(std::size_t triangle) const {
  const auto& [a, b, c] = surface_.triangles[triangle];
  return {surface_.points[a], surface_.points[b], surface_.points[c]};
}

bool surface_tree::comes_within(vec3 p, double distance) const {
  return boxes_.any_meeting(box{p, p}.grown(distance), [&](std::size_t i) {
    const auto [a, b, c] = corners(i);
    return point_to_triangle(p, a, b, c) < distance;
  });
}

int surface_tree::winding(vec3 p, vec3 along) const {
  const auto all = boxes_.extent();
  if (!all.meets({p, p}))
    return 0;
  // From inside their box it ends beyond all triangles.
  const axis_ray ray(p, along, 2 * norm(all.high - all.low));
  int sum = 0;
  (void)boxes_.any_meeting(ray.extent(), [&](std::size_t i) {
    sum += ray.crossing(corners(i));
    return false;
  });
  return sum;
}

}  // namespace tedit::ops
