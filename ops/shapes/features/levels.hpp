// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/features/protrusion.hpp"
#include "ops/shapes/caps/quadric.hpp"

namespace tedit::ops {

/// What is left where a protrusion came off: the surface it stood on, continued under it.
struct level {
  vec3 point;
  vec3 normal;                        ///< Unit, towards the protrusion.
  std::optional<quadric> curved;      ///< Takes the plane's place.
  double tolerance = 0;               ///< Vertices as near as this lie on it, m.
  std::optional<surface_id> surface;  ///< The one around it, when there is only one.

  /// Distance of p, positive on the protrusion's side, m; exact for a plane, to first order else.
  [[nodiscard]] double value(vec3 p) const {
    return curved ? curved->signed_distance(p) : dot(p - point, normal);
  }
};

/// One level for each foot. Errors: `not_a_protrusion` naming a bent foot that lies on no
/// second-order surface.
[[nodiscard]] expected<std::vector<level>> levels_of(const mesh_version& mesh,
                                                     const protrusion& feature);

}  // namespace tedit::ops
