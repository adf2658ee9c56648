// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "compare/comparison.hpp"
#include "compare/match.hpp"

namespace tedit {

/// How far the boundaries are apart, looked at from corners and middles of the facets that only one
/// version has. Errors: `cancelled`. Cost: nothing when no facet differs; else O(facets log facets)
/// for the boundary and O(log facets) for each that differs.
[[nodiscard]] expected<boundary_deviation> deviation_of(const mesh_version& before,
                                                        const mesh_version& after,
                                                        const version_match& match,
                                                        const execution& run);

}  // namespace tedit
