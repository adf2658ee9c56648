// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ops/sdk/operation.hpp"
#include "ops/shapes/features/motion.hpp"

namespace tedit::ops {

/// A lid of a feature's shape: what closes it where the part begins (a boss) or ends (a hole).
struct lid {
  std::vector<std::uint32_t> points;  ///< Of the tool, ascending.
  /// Its outer edges, as its triangles have them.
  std::vector<std::array<std::uint32_t, 2>> rim;
  std::vector<bool> runs_on;  ///< Of each: past it its wall is still what it is, as a cone is not.
  vec3 normal;                ///< Unit, out of the tool.
  vec3 way;  ///< Unit: which way the walls go on, where they all go one way; else the normal.
};

/// A hole or a boss as a shape of its own, with the triangles that the part has there.
struct feature_tool {
  boolean_mode mode = boolean_mode::cut;  ///< What makes it again: cut for a hole, add for a boss.
  tool_surface tool;
  std::vector<std::optional<surface_id>> surfaces;  ///< That each face is a copy of.
  std::vector<lid> lids;
};

/// The features that some surfaces belong to.
struct picked_features {
  boolean_mode mode = boolean_mode::cut;
  std::vector<surface_id> surfaces;  ///< Ascending, as completed.
  std::vector<feature_tool> tools;   ///< One for each hole or boss.
};

/// Completes each pick to the hole, boss, rib or fin that it belongs to and closes these over their
/// rims. Errors: `not_a_protrusion` for a pick that is neither, `invalid_argument` for both at
/// once; those of `close_shell`. Cost: O(facet slots) a pick.
[[nodiscard]] expected<picked_features> pick_features(const mesh_version& mesh,
                                                      const std::vector<surface_id>& picked,
                                                      context& ctx);

/// The feature's shape where a motion brings it: a hole reaches out of the part there, a boss down
/// to it, by a layer on their lids, along their walls. `size` (m): the part's mean edge length
/// there. Cost: O(facet slots) for each point of a rim.
[[nodiscard]] tool_surface placed(const mesh_version& mesh, const feature_tool& feature,
                                  const motion& way, double size);

}  // namespace tedit::ops
