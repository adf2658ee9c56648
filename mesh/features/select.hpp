// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "base/execution.hpp"
#include "mesh/version.hpp"

namespace tedit {

// Selection helpers: what a person means by one pick, as surfaces of the mesh.

enum class feature_kind {
  hole,        ///< The whole hole that one wall surface belongs to.
  protrusion,  ///< The boss, rib or fin that one of its surfaces belongs to.
  holes,       ///< All round holes of a diameter.
  smooth,      ///< All surfaces that hang together over edges of a small angle.
  neighbours   ///< Those next to the selection over edges of a small angle.
};

[[nodiscard]] std::string_view kind_name(feature_kind kind) noexcept;

struct selection_query {
  feature_kind kind = feature_kind::hole;
  std::vector<surface_id> surfaces;  ///< What was picked; not for `holes`.
  /// For smooth and neighbours: edges whose mean material angle is this near to 180 degrees, rad.
  double angle = 0.35;
  double min_diameter = 0;  ///< For holes, m, inclusive.
  double max_diameter = 1e300;
};

struct found_feature {
  feature_kind kind = feature_kind::hole;  ///< hole, protrusion, or smooth for a mere set.
  std::vector<surface_id> surfaces;        ///< Ascending.
  double diameter = 0;                     ///< Of a round hole's narrowest rim, m; else 0.
  vec3 centre;                             ///< Of that rim, m.
  vec3 axis;                               ///< Unit, out of the part; zero when not round.
};

/// Answers a query. A flat wall, and one with nothing but roundings at its edges, is neither a hole
/// nor a protrusion. One feature, or for holes any number, by falling area of their walls. Errors:
/// `surface_not_found`, `empty_selection`, `mixed_rim`, `not_a_hole`, `not_a_protrusion`,
/// `invalid_argument`, `cancelled`. Cost: O(boundary); for holes times the number of holes' walls.
[[nodiscard]] expected<std::vector<found_feature>> select_surfaces(const mesh_version& mesh,
                                                                   const selection_query& query,
                                                                   const execution& run);

}  // namespace tedit
