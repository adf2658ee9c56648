// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/box.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Mean length of the edges of the boundary facets that meet a box, of all where none does; m. What
/// a tool's triangles should measure there. Cost: O(facet slots).
[[nodiscard]] double local_size(const mesh_version& mesh, const box& where);
[[nodiscard]] double local_size(const mesh_version& mesh, const tool_surface& tool);

/// What a closed surface encloses, m^3 where its points are in m; negative where it looks inward.
/// Taken from its first point, exact far from the origin. Cost: O(triangles).
[[nodiscard]] double enclosed_volume(const std::vector<vec3>& points,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// The box of the part's live vertices, and of a tool's points. Cost: O(vertex slots), O(points).
[[nodiscard]] box extent_of(const mesh_version& mesh);
[[nodiscard]] box extent_of(const tool_surface& tool);

/// The live tets of `after` that are not those of `before`, or have another place for a corner:
/// what several booleans have touched together, ascending. Cost: O(slots of pages that differ).
[[nodiscard]] std::vector<tet_id> changed_tets(const mesh_version& before,
                                               const mesh_version& after);

/// The least radius ratio of some tets; 1 of none. Cost: O(tets).
[[nodiscard]] double worst_quality(const mesh_version& mesh, const std::vector<tet_id>& tets);

/// Where a ray passes through the boundary.
struct ray_hit {
  double distance = 0;  ///< m, along the unit direction.
  facet_id facet = no_id;
  bool leaves = false;  ///< The material ends here; else it begins.
};

/// All of them ahead of the origin, ascending. Cost: O(facet slots).
[[nodiscard]] std::vector<ray_hit> ray_hits(const mesh_version& mesh, vec3 origin, vec3 direction);

/// The nearest point of a surface to its centroid, with the unit outward normal there.
struct wall_middle {
  vec3 point;
  vec3 normal;
};

/// Errors: `surface_not_found`. Cost: O(facets of the pages that hold some of it).
[[nodiscard]] expected<wall_middle> middle_of(const mesh_version& mesh, surface_id surface);

/// The unit outward normal of the boundary facet nearest to a point, of these surfaces alone where
/// some are named. Cost: O(facet slots).
[[nodiscard]] vec3 outward_at(const mesh_version& mesh, vec3 point,
                              const std::vector<surface_id>& surfaces = {});

}  // namespace tedit::ops
