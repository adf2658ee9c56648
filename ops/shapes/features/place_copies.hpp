// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/features/feature_tool.hpp"

namespace tedit::ops {

/// What `place_copies` starts from.
struct copy_source {
  version_ptr base;   ///< The part before the edit.
  version_ptr start;  ///< What the copies are made on: `base`, or what is left without the feature.
  double volume_change = 0;  ///< From `base` to `start`, m^3.
  bool keeps_ids = false;  ///< The walls of the (only) copy get the ids of what they are copies of.
};

/// Makes the features again where each motion brings them: many at once, those that overlap one
/// after the other. Errors: `invalid_parameter` for more than 100 of the latter; those of
/// `services::boolean_onto` naming which copy, `invalid_argument` where the part would fall into
/// pieces or a boss would not touch it, `cancelled`. Cost: a boolean for 4000 triangles of
/// tools, at least, and a test of each pair of copies.
[[nodiscard]] expected<edit_result> place_copies(const copy_source& from,
                                                 const picked_features& features,
                                                 const std::vector<motion>& motions, context& ctx);

}  // namespace tedit::ops
