// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"
#include "ops/shapes/rounding/round_strips.hpp"

namespace tedit::ops {

/// What `open` and `close` are asked for: radius and segments.
[[nodiscard]] std::vector<parameter_description> round_parameters();
[[nodiscard]] round_settings read_round_parameters(const parameters& values);

/// Rounds the inner corners (`side` +1, material is added) or the outer edges (-1, material is
/// taken off) between the selected surfaces, or all around a single one, with the surface of a ball
/// that rolls along both walls: the exact morphological closing or opening there. The tets around
/// the edges give way to new ones whose vertices on the rounded surface lie at exactly the radius.
/// Each run of edges gets a new surface; what is left of the walls keeps theirs. Errors:
/// `empty_selection` without such an edge, `invalid_argument` where the radius or the shape does
/// not fit (named with the place), `cap_intersects`, `mesher_failed`, `timeout`, `cancelled`. Cost:
/// O(boundary + tets around the edges).
[[nodiscard]] expected<edit_result> round_edges(const version_ptr& mesh,
                                                const std::vector<surface_id>& surfaces,
                                                double side, const round_settings& settings,
                                                context& ctx);

}  // namespace tedit::ops
