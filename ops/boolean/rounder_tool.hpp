// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The tool with shorter chords of its faces that say of what round wall they are: edges are halved
/// until their middles are no further off the walls than `most_off` (m), with the new vertices on
/// all that meets there. So a copy of a bore of six facets meets a wall where the bore would.
/// Nothing where there are no such chords. Cost: O(triangles), and some microseconds a new vertex.
[[nodiscard]] std::optional<tool_surface> with_shorter_chords(const tool_surface& tool,
                                                              double most_off);

}  // namespace tedit::ops
