// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <span>
#include <vector>

#include "client/surface.hpp"

/// Where a point of the part is, in words.
namespace tedit::desktop {

/// The surfaces that are nearest to a point: one, or those that meet where it lies.
struct found_place {
  std::vector<surface_id> surfaces;  ///< Ascending; none when the part has no facet.
  double depth_m = 0;  ///< From the nearest of them; 0 for a point on it (to rounding).
  vec3 outward;        ///< Unit: the mean of the normals of the nearest facets; 0 when they cancel.

  friend bool operator==(const found_place&, const found_place&) = default;
};

/// The places of some points, m, one for each. On any thread. Cost: O(facets) for all together, and
/// a distance to a triangle for those facets that may be the nearest.
[[nodiscard]] std::vector<found_place> find_places(const client::surface_model& on,
                                                   std::span<const vec3> points);

using surface_names = std::function<QString(surface_id)>;

/// "Bore wall", "where Bore wall and Top meet", "inside, 1.2 mm from Top". Empty for no surface.
[[nodiscard]] QString words(const found_place& place, const surface_names& names);

}  // namespace tedit::desktop
