// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "compare/comparison.hpp"
#include "compare/match.hpp"
#include "fem/load_case.hpp"

namespace tedit {

/// A version with the load cases that it has.
struct version_side {
  const mesh_version& mesh;
  std::span<const fem::load_case> load_cases = {};
};

/// Everything but fields: surfaces, size, mass, tets in common, how far the boundaries are apart,
/// load cases. `match` must be that of the two. Errors: `cancelled`. Cost: O(tets) for volumes, the
/// rest O(what changed) and `deviation_of`.
[[nodiscard]] expected<version_comparison> compare_versions(const version_side& before,
                                                            const version_side& after,
                                                            const version_match& match,
                                                            const execution& run);

}  // namespace tedit
