// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>

#include "client-qt/view/camera.hpp"
#include "client-qt/view/part_geometry.hpp"
#include "client-qt/view/scene.hpp"

namespace tedit::desktop {

/// The first point on a ray that is drawn: what is hidden or cut away is looked through.
[[nodiscard]] std::optional<picked_point> pick_visible(const part_geometry& part,
                                                       const std::set<surface_id>& hidden,
                                                       const std::optional<section_plane>& section,
                                                       vec3 from, const vec3& to);

/// A box on the screen.
struct pick_box {
  enum class rule {
    touched,  ///< Surfaces of which something can be seen in the box.
    enclosed  ///< Those of them that lie in it altogether, seen or not.
  };

  rule by = rule::touched;
  double left = 0;  ///< Pixels from the lower left, as all here.
  double bottom = 0;
  double width = 0;
  double height = 0;
  /// Rays through the corners: lower left, lower right, upper left, upper right.
  std::array<std::array<vec3, 2>, 4> rays{};
  camera::projection to_pixels;
  std::set<surface_id> hidden;
  std::optional<section_plane> section;
};

/// The surfaces in a box, ascending. What can be seen is found by rays, 4 pixels apart or, in a
/// large box, a 96th of its side: a surface that is nowhere that large may be missed. On any
/// thread. Cost: 9216 rays at most, and O(points).
[[nodiscard]] std::vector<surface_id> surfaces_in(const part_geometry& part, const pick_box& box);

}  // namespace tedit::desktop
