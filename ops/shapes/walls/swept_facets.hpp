// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include "mesh/builder.hpp"

namespace tedit::ops {

/// Where a moving boundary meets another part of it.
struct boundary_meeting {
  surface_id surface = 0;
  vec3 place;
};

/// The first place at which the facets of moved vertices would meet facets with which they share no
/// vertex, or at which such a facet's corner lies in what they sweep; nothing when all is clear.
/// @param places where the moved vertices go. Cost: O(facet slots + moved facets x facets near).
[[nodiscard]] std::optional<boundary_meeting> first_meeting(
  const mesh_builder& mesh, const std::map<vertex_id, vec3>& places);

}  // namespace tedit::ops
