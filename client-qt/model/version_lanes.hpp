// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace tedit::desktop {

/// Where a version stands in the drawn tree of versions.
struct version_place {
  int column = 0;  ///< Edits from the root on.
  int lane = 0;    ///< 0: the root's; branches stand below.

  friend bool operator==(const version_place&, const version_place&) = default;
};

/// The places of versions by number, each with its parent's number. The first child goes on in its
/// parent's lane; every other one begins a branch in the nearest lane below that has room for it.
/// No two versions share a place, and in a lane nobody stands between a version and its child.
/// Parents come before their children. A parent that is not there makes a root. Cost: O(n^2) at
/// worst, for a version with n branches.
[[nodiscard]] std::map<std::uint32_t, version_place> lanes_of(
  const std::map<std::uint32_t, std::optional<std::uint32_t>>& parents);

}  // namespace tedit::desktop
