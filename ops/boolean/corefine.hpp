// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// A plane on which points of both surfaces lie: they are moved there exactly, so that faces that
/// should be flush are.
struct shared_plane {
  vec3 normal;                                       ///< Unit.
  double offset = 0;                                 ///< m: points p with normal . p = offset.
  std::array<std::vector<std::uint32_t>, 2> points;  ///< Of the first and the second surface.
};

/// What an exact boolean leaves, without triangles that lie back to back.
struct corefined {
  std::vector<vec3> points;
  std::vector<std::int32_t> origin;  ///< Of each point: that of the first surface, or -1.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Of each triangle: the one of the first surface that it is a part of, or -1 less the second's.
  std::vector<std::int32_t> parent;
  /// Of each triangle, the share of the first surface that it bounds, and the one beyond it or -1.
  std::vector<std::array<std::int32_t, 2>> sides;
  double volume_change = 0;  ///< m^3: of the result less that of the first surface.
};

/// One of several closed surfaces that touch.
struct solid_share {
  std::uint32_t triangles = 0;
  bool stays = false;  ///< It gets the other surface's edges only.
};

/// The exact boolean of two closed surfaces, in the program `tedit-mesher` under limits. The first
/// one may be several that touch, its shares: each that does not stay is combined, or where
/// something is added the one of those of which most is covered gets what is outside of the others,
/// which get its edges. What two of the results have in common is there twice (see `join_shares`).
/// Errors:
/// `invalid_argument` where the second passes through itself, `mesher_failed` naming the reason,
/// `timeout`, `cancelled`, `service_unavailable`. Cost: 10 ms and 10 us a triangle.
[[nodiscard]] expected<corefined> corefine(const closed_surface& first,
                                           const std::vector<solid_share>& shares,
                                           const closed_surface& second, boolean_mode mode,
                                           const std::vector<shared_plane>& planes,
                                           const execution& run);

}  // namespace tedit::ops
