// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "ops/tools/tools.hpp"

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

/// What the parameters of the operation ask for.
[[nodiscard]] rib_shape rib_shape_of(const parameters& values);

/// A rib as a solid, before it is divided into triangles: a polygon, half the thickness to each
/// side of the frame's plane of x and y.
struct rib_prism {
  frame place;
  std::vector<std::array<double, 2>> points;  ///< m.
  double thickness = 0;                       ///< m.
  double local = 0;                           ///< m: the part's mean edge there.
};

/// Errors: `invalid_argument` for walls that look the same way or away from each other,
/// `invalid_parameter` where it is not known which way it stands.
[[nodiscard]] expected<rib_prism> rib_prism_of(const mesh_version& mesh,
                                               const std::vector<surface_id>& walls,
                                               const rib_shape& shape);

/// A plate between two walls, united with the part: where they meet at an angle a triangle in their
/// corner (a gusset), where they face each other a rectangle from one to the other. Walls are taken
/// as they are where the rib meets them; it reaches a little into walls that are not flat. Errors:
/// `invalid_argument` for walls that look the same way or away from each other, or where the rib
/// would not touch both; those of `services::boolean`.
[[nodiscard]] expected<edit_result> add_rib(const version_ptr& mesh,
                                            const std::vector<surface_id>& walls,
                                            const rib_shape& shape, context& ctx);

}  // namespace tedit::ops
