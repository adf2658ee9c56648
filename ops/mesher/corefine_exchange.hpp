// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace tedit::ops {

/// What passes between `tedit-mesher` and who started it, little-endian.
///
/// In: the header; for each of the two surfaces its points (3 doubles each) and triangles (3
/// indices each); of the first one, which may be several closed surfaces that touch (the shares of
/// bonded regions), a `corefine_share` each, one after the other; the planes, each a
/// `corefine_plane` and then the indices of the first and of the second surface's points that lie
/// on it.
/// Out: a `corefine_answer`; points (3 doubles each); the point of the first surface that each one
/// is, or -1; triangles (3 indices each); what each one is a part of: a triangle of the first
/// surface, or -1 less one of the second; the share that each one bounds.
/// Each share that does not stay is combined with the second surface, the others only get its
/// edges. Where the mode is 1 and there are several, one of those gets what is outside of all
/// others, and all others only get its edges: the one of whose surface most is covered.
struct corefine_header {
  std::uint32_t magic = 0x54424c33;  // "TBL3"
  std::uint32_t mode = 0;            ///< 0: first less second, 1: both together, 2: common to both.
  std::uint32_t points[2] = {0, 0};
  std::uint32_t triangles[2] = {0, 0};
  std::uint32_t shares = 1;
  std::uint32_t planes = 0;
  std::uint32_t most_ms = 0;  ///< Of processor time, see `end_after`.
};

struct corefine_share {
  std::uint32_t triangles = 0;
  std::uint32_t stays = 0;  ///< 1: it only gets the second surface's edges.
};

struct corefine_plane {
  double normal[3] = {0, 0, 0};
  double offset = 0;  ///< Points p with normal . p = offset, as rational numbers.
  std::uint32_t points[2] = {0, 0};
};

enum class corefine_status : std::uint32_t {
  done = 0,
  first_not_manifold,
  second_not_manifold,
  result_not_manifold,
  second_meets_itself,
  failed,
};

struct corefine_answer {
  std::uint32_t magic = corefine_header{}.magic;
  corefine_status status = corefine_status::failed;
  std::uint32_t points = 0;
  std::uint32_t triangles = 0;
  double volume_before = 0;  ///< Exact but for the last rounding: of the first surface, and
  double volume_after = 0;   ///< of the result.
};

}  // namespace tedit::ops
