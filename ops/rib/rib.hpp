// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

struct rib_shape {
  double thickness = 0;  ///< m.
  double size =
    0;  ///< m: of its legs along the walls; between walls that face each other, how high.
  std::optional<vec3> at;  ///< m: a point of its middle plane; nothing: by the walls' middles.
  /// Which way a rib between walls that face each other stands; nothing: away from the part's
  /// middle, across the walls.
  std::optional<vec3> direction;
};

/// A plate between two walls, united with the part: where they meet at an angle a triangle in their
/// corner (a gusset), where they face each other a rectangle from one to the other. Walls are taken
/// as they are where the rib meets them; it reaches a little into walls that are not flat. Errors:
/// `invalid_argument` for walls that look the same way or away from each other, or where the rib
/// would not touch both; those of `services::boolean`.
[[nodiscard]] expected<edit_result> add_rib(const version_ptr& mesh,
                                            const std::vector<surface_id>& walls,
                                            const rib_shape& shape, context& ctx);

}  // namespace tedit::ops
