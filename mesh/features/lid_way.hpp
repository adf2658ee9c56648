// SPDX-License-Identifier: AGPL-3.0-or-later
// Where a hole or boss that is made again elsewhere goes on past its lids, on the mesh as on the
// CAD model.
#pragma once

#include <array>
#include <span>

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
};

/// Unit: the direction that the planes and cylinders at a lid all go along, where it leads out of
/// the lid and the rim does not go that way for a bit, as where a hole is open at its side; else,
/// and with another shape among them, `outward`.
/// @param outward unit, out of the feature's body. @param rim the lid's edges.
/// Cost: O(walls^2 + rim).
[[nodiscard]] vec3 way_past_lid(std::span<const surface_geometry> walls, vec3 outward,
                                std::span<const std::array<vec3, 2>> rim);

}  // namespace tedit
