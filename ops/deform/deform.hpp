// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/deform/deform_zone.hpp"

namespace tedit::ops {

/// What is dragged, where to, and what follows; lengths in m.
struct deform_settings {
  std::optional<vec3> at;  ///< A patch around this place; else the whole surfaces.
  double radius = 0;       ///< Of the patch; 0: about two edges.
  double distance = 0;     ///< Along the mean outward normal; not with `by`.
  std::optional<vec3> by;  ///< The way itself.
  double reach = 0;        ///< 0: the side of a square as large as what is dragged, or four edges.
  kept_walls kept = kept_walls::flat_and_round;
  std::vector<surface_id> stay;
  bool keep_volume = false;
};

/// Drags surfaces or a patch of them; what is around follows as the field that bends least,
/// vertices alone move. With `keep_volume` the free vertices give way as a plate bends under
/// pressure until the volume is what it was. Errors: `invalid_parameter` for a way of 0,
/// `inverted_tet` naming place and quality of the tet that would become too flat,
/// `invalid_argument` where the boundary would run into itself, both with the most that works;
/// those of the zone. Cost: O(mesh), and the field's (ops/shapes/deform/smooth_field.hpp); a
/// refusal tries some ways more.
[[nodiscard]] expected<edit_result> deform(const version_ptr& mesh,
                                           const std::vector<surface_id>& surfaces,
                                           const deform_settings& settings, context& ctx);

}  // namespace tedit::ops
