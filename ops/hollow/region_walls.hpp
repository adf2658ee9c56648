// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What bounds a part, or one of its regions: also where that meets another one.
struct region_walls {
  std::vector<std::array<vertex_id, 3>> triangles;  ///< Seen from outside counter-clockwise.
  std::vector<std::optional<surface_id>> surfaces;  ///< Of each; nothing between two regions.
  box extent;
  double area = 0;  ///< m^2
};

/// `region`: nothing for the whole part. Cost: O(facet slots), with a region O(tet slots).
[[nodiscard]] region_walls walls_of(const mesh_version& mesh, std::optional<region_id> region);

/// The region that is meant: by its name or number, else the one of the walls that were picked;
/// nothing where there is but one. Errors: `invalid_parameter` for one that is not there, where
/// none is named and none picked, and where walls of others were picked.
[[nodiscard]] expected<std::optional<region_id>> region_meant(
  const mesh_version& mesh, const std::string& text, const std::vector<surface_id>& picked);

}  // namespace tedit::ops
