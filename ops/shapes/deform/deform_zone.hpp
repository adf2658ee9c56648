// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What is dragged: facets whose vertices all go the same way.
struct drag_handle {
  std::vector<facet_id> facets;
  std::vector<vertex_id> vertices;   ///< Ascending.
  std::vector<surface_id> surfaces;  ///< On which the facets lie, ascending.
  double area = 0;                   ///< m^2.
  vec3 area_vector;                  ///< m^2, outward.

  /// The mean outward normal. Errors: `invalid_parameter` where the facets face all ways.
  [[nodiscard]] expected<vec3> normal() const;
};

/// Whole surfaces. Errors: `empty_selection` naming one without an outer side. Cost: O(surfaces).
[[nodiscard]] expected<drag_handle> handle_of(const mesh_version& mesh,
                                              const std::vector<surface_id>& surfaces);

/// The patch around the point of the boundary that is nearest to a place: what of that point's
/// surface (of the `surfaces` where some are named) lies within `radius` (m; 0: about two edges)
/// and hangs together with it; at least one facet. Errors: `empty_selection` where the place is
/// further from the boundary than that. Cost: O(facet slots).
[[nodiscard]] expected<drag_handle> handle_at(const mesh_version& mesh, vec3 place, double radius,
                                              const std::vector<surface_id>& surfaces);

/// Which surfaces stay as a whole although the reach goes over them, unless they belong to what is
/// dragged: flat walls and round ones, round ones alone, or none.
enum class kept_walls { flat_and_round, round, none };

struct zone_settings {
  double reach = 0;  ///< m.
  kept_walls kept = kept_walls::flat_and_round;
  std::vector<surface_id> stay;  ///< These stay, too.
};

/// What follows what is dragged.
struct deform_zone {
  std::vector<vertex_id> free;   ///< Vertices, ascending.
  std::vector<tet_id> tets;      ///< With at least one of those or of the handle, ascending.
  std::vector<surface_id> kept;  ///< Surfaces within reach that stay, ascending.
};

/// Vertices nearer to the handle than the reach that hang together with it over others, but for
/// those of surfaces that stay. Neighbours of what is dragged never stay by themselves: those that
/// touch it, and what touches them where they are of free form, fillets, or nowhere further off
/// than a quarter of the reach, but for flat walls that face the other way.
/// Errors: `surface_not_found`, `invalid_parameter` naming a surface that is to stay and touches
/// the handle; `cancelled`. Cost: O(mesh).
[[nodiscard]] expected<deform_zone> zone_around(const mesh_version& mesh, const drag_handle& handle,
                                                const zone_settings& settings,
                                                const execution& run);

}  // namespace tedit::ops
