// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/features/round_fit.hpp"

namespace tedit {

/// The exact surface behind a wall: a plane, a cylinder, a cone, a sphere or a torus; free form,
/// too, where a CAD model has it or its corners say it (`fitted_form`).
struct exact_wall {
  /// Of a sphere centre (as point) and side, of a torus axis and radius, too; of free form the
  /// side.
  wall_shape shape;
  double sphere_radius = 0;                                       ///< m; 0: no sphere.
  double tube_radius = 0;                                         ///< m; 0: no torus.
  std::shared_ptr<const surface_projection> free_form = nullptr;  ///< Of free form alone.
  double vague = 0;       ///< m: so far may edges of the CAD model be off it.
  bool is_known = false;  ///< By the CAD model: however few corners there are, it is no guess.

  [[nodiscard]] bool flat() const {
    return sphere_radius == 0 && tube_radius == 0 && !free_form &&
           shape.type == wall_shape::kind::plane;
  }
  /// Signed, m: positive off the material.
  [[nodiscard]] double distance(vec3 p) const;
  /// Unit, outward: the gradient of `distance`.
  [[nodiscard]] vec3 normal(vec3 p) const;
  /// Both at once, for the cost of one where the wall is of free form.
  struct reading {
    double distance = 0;
    vec3 normal;
  };
  [[nodiscard]] reading at(vec3 p) const;
  /// The nearest point of the wall.
  [[nodiscard]] vec3 project(vec3 p) const { return p - distance(p) * normal(p); }
  /// m: of the wall's circle at p, the narrower one of a torus; that of a plane is infinite, of
  /// free form the least near p, and at a cone's tip it is small, but not none: what is near is
  /// told by shares of it.
  [[nodiscard]] double radius_at(vec3 p) const;
};

/// Fitted to all corners, within 1e-4 of the radius; nothing for free form. Each point is a corner
/// of some triangle. Cost: O(triangles).
[[nodiscard]] std::optional<exact_wall> fit_exact(const facet_corners& wall);

/// Gives the wall the side on which most of the triangles have the material. Cost: O(triangles).
void turn_outward(const facet_corners& facets, exact_wall& wall);

/// Are the corners of a part's wall as many as those of a round one? Those of a hexagon lie on a
/// cylinder, too, unless the CAD model says which it is. Cost: O(points log points).
[[nodiscard]] bool has_round_corners(const exact_wall& wall, std::span<const vec3> points);

/// How wide the gaps between corners around a cylinder's or cone's axis are, rad: the two widest,
/// the wider one first. Cost: O(points log points).
[[nodiscard]] std::array<double, 2> gaps_around(const wall_shape& shape,
                                                std::span<const vec3> points);

/// What a vertex must lie on: an exact wall, or a plane.
struct wall_demand {
  const exact_wall* wall = nullptr;  ///< Null: the plane.
  vec3 point;                        ///< On the plane.
  vec3 normal;                       ///< Unit; of the plane.
  bool free_form = false;            ///< Nobody knows whether the wall is that plane.
};

/// A place on all that is demanded.
struct wall_place {
  vec3 at;
  double before = 0;   ///< m: how far the vertex is off the walls.
  double after = 0;    ///< m: and the place.
  bool found = false;  ///< False also where the walls touch without crossing, or too far away.
};

/// The nearest point to `start` on the walls and planes: Newton's method with the shortest steps.
/// What follows from the demands before it, or has nothing to do with them (walls that touch, more
/// than three), is only looked at: `after` is of all. It may be half of the least radius away. Free
/// form that a round wall runs into smoothly demands nothing: its plane is a chord of both.
/// Cost: O(demands) some times.
[[nodiscard]] wall_place place_on_walls(const std::vector<wall_demand>& demands, vec3 start);

}  // namespace tedit
