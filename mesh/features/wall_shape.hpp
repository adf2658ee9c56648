// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "mesh/version.hpp"

namespace tedit {

/// The exact surface behind a mesh surface: a plane, a round cylinder or a round cone, with the
/// side on which the material lies.
struct wall_shape {
  enum class kind { plane, cylinder, cone };

  kind type = kind::plane;
  vec3 point;         ///< On the plane, or on the axis.
  vec3 axis;          ///< Unit: the outward normal, or the axis' direction.
  double radius = 0;  ///< m; of the cylinder, of the cone at `point`.
  double side = 1;    ///< +1: material inside the cylinder (a boss), -1: outside (a hole).
  double slope = 0;   ///< By how much a cone's radius grows along the axis, m per m.

  /// Signed distance, m: positive off the material.
  [[nodiscard]] double distance(vec3 p) const;

  /// Unit, outward, at the nearest point of the shape; the gradient of `distance`. On a cone's axis
  /// the part of it along the axis.
  [[nodiscard]] vec3 normal(vec3 p) const;

  /// The nearest point of the shape.
  [[nodiscard]] vec3 project(vec3 p) const { return p - distance(p) * normal(p); }
};

/// What counts as round.
struct fit_limits {
  double roundness = 1e-4;  ///< Corners may be so far off, as a share of the radius.
  /// Facets of a cylinder may be wider than 75 degrees, as long as no gap between corners is.
  bool wide_facets = false;
  bool cones = false;
};

/// What counts as round where a wall moves. A vertex that is a little off the shape stays as far
/// off.
inline constexpr fit_limits round_enough{3e-3, true, true};

/// Fits a plane (within 1e-6 of the surface's size) or a cylinder (within 1e-4 of its radius), with
/// `cones` also a cone, to all corners of the facets; where the CAD model says what the wall is,
/// and it holds (mesh/features/known_wall.hpp), that. Nothing for any other shape. Cost: O(facets).
[[nodiscard]] std::optional<wall_shape> fit_wall(const mesh_version& mesh,
                                                 std::span<const facet_id> facets,
                                                 const fit_limits& limits = {});

}  // namespace tedit
