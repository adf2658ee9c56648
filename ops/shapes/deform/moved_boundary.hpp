// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Where a boundary runs into itself.
struct collision {
  surface_id first = 0;
  surface_id second = 0;
  vec3 at;  ///< m: the middle of a facet there.
};

/// The first pair of facets that have a point in common when the vertices have gone to new places
/// and had none before; facets that share a vertex are passed over: between them there is a tet.
/// `places`: by vertex slot of those in `moved`. Cost: O(facet slots + moved facets).
class moved_boundary {
public:
  /// Cost: O(facet slots).
  moved_boundary(const mesh_version& mesh, std::vector<vertex_id> moved);

  /// `places` in the order of the moved vertices, m. Errors: `cancelled`.
  [[nodiscard]] expected<std::optional<collision>> meets_itself(std::span<const vec3> places,
                                                                const cancel_token& cancel) const;

private:
  [[nodiscard]] std::array<vec3, 3> triangle(facet_id f, std::span<const vec3> places) const;

  const mesh_version& mesh_;
  std::vector<vertex_id> moved_;
  std::vector<facet_id> facets_;  ///< With a moved vertex.
};

}  // namespace tedit::ops
