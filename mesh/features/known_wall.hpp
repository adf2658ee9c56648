// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "mesh/features/exact_wall.hpp"

namespace tedit {

/// Does the version come of a CAD model that says of some surface what it is? Cost: O(surfaces).
[[nodiscard]] bool has_geometries(const mesh_version& mesh);

/// The wall, free form, too, that the CAD model has behind facets of one surface, as long as it
/// holds of them: their corners are on it to rounding, or as near as edges of the CAD model are,
/// but for what a mesher's repair may have moved: one corner, or three of a hundred, by 2 % of the
/// radius or of the facets' extent. So an edit that moves the facets needs to tell nobody. Nothing
/// where the version has no geometry of the surface, or it does not hold any more. Cost:
/// O(corners), of free form some microseconds each.
[[nodiscard]] std::optional<exact_wall> known_wall(const mesh_version& mesh,
                                                   std::span<const facet_id> facets,
                                                   const facet_corners& corners);

/// What a geometry says, whether or not it holds of the facets: nothing where its numbers make no
/// wall.
[[nodiscard]] std::optional<exact_wall> stated_wall(const surface_geometry& geometry,
                                                    const facet_corners& corners);

/// The same where it holds: of a geometry that no version has, as of a tool.
[[nodiscard]] std::optional<exact_wall> known_wall(const surface_geometry& geometry,
                                                   const facet_corners& corners);

/// `known_wall`, else `fit_exact`. Cost: that of a fit.
[[nodiscard]] std::optional<exact_wall> find_exact(const mesh_version& mesh,
                                                   std::span<const facet_id> facets);

/// Of a wall that is no free form.
[[nodiscard]] surface_geometry geometry_of(const exact_wall& wall);

/// What is behind all facets of a surface: what the CAD model says, where it holds, else what their
/// corners say; none where that is a guess. Cost: that of a fit.
[[nodiscard]] surface_geometry find_geometry(const mesh_version& mesh, surface_id id);

}  // namespace tedit
