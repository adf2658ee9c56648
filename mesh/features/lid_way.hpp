// SPDX-License-Identifier: AGPL-3.0-or-later
// Where a hole or boss that is made again elsewhere goes on past its lids, on the mesh as on the
// CAD model.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/types.hpp"

namespace tedit {

/// Lengths, but for `within_rim`, are in local edges of the mesh.
struct lid_rules {
  /// How far a hole's shape reaches out of the part and a boss's into it.
  static constexpr double out_of_part = 0.5;
  static constexpr double into_part = 0.2;
  /// What is nearer lies on the part's surface.
  static constexpr double on_surface = 1e-3;
  /// Rays begin this share of the way from the rim to its middle: those from the rim itself run
  /// along the walls of a hole that the copy is in line with.
  static constexpr double within_rim = 0.01;
  /// And of what is free before more material begins a hole takes this share at most.
  static constexpr double of_gap = 0.5;
};

/// Where a ray from a lid passes through the part's boundary.
struct lid_hit {
  double distance = 0;
  bool leaves = false;  ///< The material ends there; else it begins.
};

/// How far a hole goes on past its lid: until all of its rim is out of the material that it is in,
/// and a bit into the open, but not into what the part has behind that.
/// @param rays of points of the rim, each ascending. @param edge the mean edge of the mesh there,
/// in the unit of the rays. Cost: O(hits).
[[nodiscard]] double reach_of_hole(std::span<const std::vector<lid_hit>> rays, double edge);

/// Unit: the direction that the planes and cylinders at a lid all go along, where it leads out of
/// the lid and the rim does not go that way for a bit, as where a hole is open at its side; else,
/// and with another shape among them, `outward`.
/// @param outward unit, out of the feature's body. @param rim the lid's edges.
/// Cost: O(walls^2 + rim).
[[nodiscard]] vec3 way_past_lid(std::span<const surface_geometry> walls, vec3 outward,
                                std::span<const std::array<vec3, 2>> rim);

}  // namespace tedit
